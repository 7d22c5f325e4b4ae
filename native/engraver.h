// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <future>
#include <list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/progress.h"
#include "pipeline/engrave.h"
#include "verdict/verdict.h"

namespace qrelief {

/// A carving, and what was found out about it.
struct Engraved {
  EngraveRequest request;  ///< as it was carved, which may be deeper than was asked for
  EngraveResult result;
  ReadingEvidence reading;
  std::optional<PrintedEvidence> printed;  ///< none: the request names no process, or it was not to be looked at
  Verdict verdict;
};

/// Engraves code after code into one model, each with all its checks. What codes share is made once: programs, and
/// places that they are asked for alike, with what was measured there. Needs the GL context of the model.
class Engraver {
 public:
  using Tell = std::function<void(const Progress&)>;

  /// @param model  checked: see PreparedModel::engravable()
  static Result<Engraver> create(std::shared_ptr<const EngravableModel> model);

  /// Carves as asked for. If the code does not read, or its print barely does, tries the changes of changeToTryNext()
  /// one after the other. The first that mends it is delivered; if none does, the code as asked for.
  /// @param looksAtPrint  find out how it comes off the printer, too, which takes two fifths of the time
  Result<Engraved> engrave(const EngraveRequest& request, const Tell& tell, bool looksAtPrint = true) const;

  /// The same once, without anything deeper.
  Result<Engraved> engraveOnce(const EngraveRequest& request, const Tell& tell) const;

  const EngravableModel& model() const { return *model_; }

 private:
  struct Place {
    int modules;
    PlacementRequest request;
    PlacementSearch found;
    std::shared_ptr<MeasuredPlace> measured;  ///< by the last carving there
  };

  struct Print {
    std::optional<PrintedEvidence> evidence;  ///< none: the request names no process
    double ms = 0;
  };
  struct Carving {
    Engraved engraved;
    std::future<Result<Print>> print;  ///< under way beside the reading of the design; not valid: it was not begun
  };

  Engraver() = default;
  Result<Place*> placeOf(const EngraveRequest& request, int modules) const;
  Result<Carving> carve(const EngraveRequest& request, const Tell& tell, bool looksAtPrint) const;
  static Result<Print> printed(const VerifyRequest& request, const Mesh& carved);
  Result<Engraved> withPrint(Carving carving, const Tell& tell) const;
  Result<Engraved> untilItPrints(Engraved asked, const Tell& tell) const;

  std::shared_ptr<const EngravableModel> model_;
  std::shared_ptr<const GeometryPass> pass_;
  std::shared_ptr<const LuminancePrograms> programs_;
  mutable std::list<Place> places_;  // the latest first
};

/// The carved model in the format of a file's name. @param ascii  see WriteOptions
Result<std::vector<std::uint8_t>> encodeCarved(const EngraveResult& result, std::span<const std::string> partNames,
                                               const std::string& fileName, bool withInlay, const std::string& title,
                                               bool ascii = false);

}  // namespace qrelief
