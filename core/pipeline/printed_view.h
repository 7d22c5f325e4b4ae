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
  ProjectionFrame frame;                          ///< of the code, mm in the model's frame
  Symbol symbol;                                  ///< of which size and colours are used
  double symbolMm = 0;                            ///< edge without quiet zone, on the QR plane, > 0
  Vec3 buildUp{0, 0, 1};                          ///< the printer's vertical, of any length > 0
  double albedo = 0.7;                            ///< of the printed material
  std::optional<DirectionalLight> oneLight = {};  ///< see VerifyRequest
  bool isRough = false;  ///< as exactly as the means over modules need, in half the time; no picture to read
};

/// The print of what is to be verified; none: how it prints is not asked for.
/// @returns BadUsage for a printer that there cannot be
Result<std::optional<PrintedViewRequest>> printedViewOf(const VerifyRequest& request);

/// A code as it comes off a printer.
struct PrintedView {
  ReaderView seen;       ///< from the front, under the sky, or the one light; its light traced on the printed surface;
                         ///< without a `picture`; empty if it was to be rough
  double facingDeg = 0;  ///< between the code's normal and the printer's vertical: 0 = it faces up, 90 = it stands
  /// Mean light of the submodules of symbol and quiet zone, row-major from the quiet zone's top left, 1 = unoccluded.
  std::vector<double> submodules;
  std::vector<std::uint8_t> misread;  ///< see misreadModules(): what the print has lost
};

/// Makes the surface that a printer leaves of a carved model (printing/printed_surface.h) and looks at it, a bounded
/// piece of work at a time; to cancel, stop calling. Needs no GL context.
class PrintedViewJob {
 public:
  /// @param mesh  a solid, mm; kept by reference until the first advance() is done
  /// @returns BadUsage for a build direction of zero
  static Result<std::unique_ptr<PrintedViewJob>> create(const Mesh& mesh, const PrintedViewRequest& request);
  ~PrintedViewJob();

  /// The next piece. After an error or `done` it must not be called again.
  Result<Progress> advance();

  /// The result, once, after `done`.
  PrintedView takeResult();

 private:
  struct State;
  explicit PrintedViewJob(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace qrelief
