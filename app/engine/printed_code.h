// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/answers.h"
#include "pipeline/printed_view.h"

namespace qrelief {

/// Returns the print parameters that Engine::printOrder() hands to PrintedCode::start().
Json jsonOf(const PrintedViewRequest& request);

/// The simulated print of a carved code. It needs no GL context, so a separate worker can simulate the print while the
/// engine goes on. Answers have the form that Engine describes.
class PrintedCode {
 public:
  /// Starts the simulation. Returns {stage, fraction, done}.
  /// @param stl    the carved model, from Engine::exportModel("stl")
  /// @param order  from Engine::printOrder()
  std::string start(std::vector<std::uint8_t> stl, const std::string& order);
  /// Does one bounded piece of work. Returns {stage, fraction, done}; when done, also {facingDeg, misread}: the angle
  /// between the code's normal and the printer's vertical, and the modules that the print has lost, [row, column] each.
  std::string advance();

  /// Returns pictures of the print. None before the simulation is done.
  /// @param of  "reading": the pictures for the decoders, see Engine::pictures(); "front": one frontal picture of
  ///            symbol, quiet zone and two modules beyond
  std::vector<GreyImage> pictures(const std::string& of) const;

 private:
  Mesh carved_;
  int modules_ = 0;
  std::unique_ptr<PrintedViewJob> job_;
  PrintedView view_;
};

}  // namespace qrelief
