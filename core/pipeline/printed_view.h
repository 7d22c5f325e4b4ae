// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "base/progress.h"
#include "base/result.h"
#include "pipeline/verify.h"
#include "printing/printed_surface.h"
#include "qr/symbol.h"
#include "verification/reader_view.h"

namespace qrelief {

struct PrintedViewRequest {
  PrintProcess process;
  ProjectionFrame frame;                     ///< frame of the code, mm in the model's coordinates
  Symbol symbol;                             ///< only its size and colours are used
  double symbolMm = 0;                       ///< edge without the quiet zone, on the QR plane, > 0
  Vec3 buildUp{0, 0, 1};                     ///< the printer's vertical, of any length > 0
  double albedo = 0.7;                       ///< of the printed material
  std::vector<DirectionalLight> lamps = {};  ///< see VerifyRequest
  Mark mark = Mark::Shadow;                  ///< see VerifyRequest
  double markDepthMm = 0;
  Ink ink = {};
  LabelOptions label = {};
  bool isRough = false;  ///< half the time, without a picture; exact enough for means over modules
};

/// Returns the print to simulate for a verification; none if the request names no process.
/// @returns BadUsage for an impossible printer
Result<std::optional<PrintedViewRequest>> printedViewOf(const VerifyRequest& request);

/// A simulated print of a code.
struct PrintedView {
  ReaderView seen;       ///< from the front, under the sky and the lamps, traced on the printed surface; no `picture`;
                         ///< empty for a rough print
  double facingDeg = 0;  ///< from the printer's vertical to the code's normal: 0 = faces up, 90 = upright
  Grid<double> submodules;     ///< mean light in symbol and quiet zone, 1 = unoccluded
  Grid<std::uint8_t> misread;  ///< see misreadModules(): modules lost in print
};

/// Simulates the printed surface of a carved model (printing/printed_surface.h) and views it, a bounded piece of work
/// at a time; to cancel, stop calling advance(). Needs no GL context.
class PrintedViewJob {
 public:
  /// @param mesh  a solid, mm; kept by reference until the first advance() returns
  /// @returns BadUsage for a build direction of zero
  static Result<std::unique_ptr<PrintedViewJob>> create(const Mesh& mesh, const PrintedViewRequest& request);
  ~PrintedViewJob();

  /// Returns the next stage and the fraction of the job that is done.
  Progress progress() const;

  /// Does the next piece of work. Do not call it again after an error or `done`.
  Result<Progress> advance();

  /// Returns the result. Call it once, after `done`.
  PrintedView takeResult();

 private:
  struct State;
  explicit PrintedViewJob(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace qrelief
