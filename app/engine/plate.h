// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/loaded_model.h"
#include "io/write_model.h"

namespace qrelief {

struct EngraveRequest;
struct EngraveResult;

/// Carved copies of a model side by side, as `qrelief batch --per-plate` writes them.
class Plate {
 public:
  bool isEmpty() const;
  /// Empties the plate. @param copies  number of copies that fit
  void start(std::size_t copies);
  /// Puts a carved copy on the plate. @param place  below copies @param id  names the copy; its text goes with it
  void add(const LoadedModel& model, const EngraveResult& result, const EngraveRequest& request, std::size_t place,
           const std::string& id);
  /// Returns the plate as a 3MF, read back and compared, and empties it. No bytes if nothing is on the plate or the
  /// file would differ from it.
  std::vector<std::uint8_t> taken(const std::string& title);

 private:
  std::vector<std::vector<ModelObject>> copies_;  // empty: not carved yet
};

}  // namespace qrelief
