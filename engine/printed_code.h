// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/answers.h"
#include "pipeline/printed_view.h"

namespace qrelief {

/// What Engine::printOrder() hands to PrintedCode::start().
Json jsonOf(const PrintedViewRequest& request);

/// A carved code as it comes off a printer, made beside the engine: it needs no GL context, so that a worker of its own
/// can make it while the engine goes on. Answers are those of Engine.
class PrintedCode {
 public:
  /// {stage, fraction, done}
  /// @param stl    the carved model, as Engine::exportModel("stl") gives it
  /// @param order  of Engine::printOrder()
  std::string start(std::vector<std::uint8_t> stl, const std::string& order);
  /// {stage, fraction, done}, one bounded piece of work; when done, too: {facingDeg, misread}, the angle between the
  /// code's normal and the printer's vertical, and the modules that the print has lost, [row, column] each.
  std::string advance();

  /// See Engine::readingPictures(). Empty before it is done.
  std::vector<GreyImage> readingPictures() const;
  /// Symbol, quiet zone and two modules beyond, from the front. Empty before it is done.
  const GreyImage& picture() const { return view_.seen.clean; }

 private:
  Mesh carved_;
  int modules_ = 0;
  std::unique_ptr<PrintedViewJob> job_;
  PrintedView view_;
};

}  // namespace qrelief
