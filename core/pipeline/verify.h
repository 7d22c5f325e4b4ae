// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "light/directional_light.h"
#include "mesh/polygon_soup.h"
#include "mesh/ray_tree.h"
#include "verification/carving_profile.h"
#include "verification/grades.h"
#include "verification/printability.h"
#include "verification/reading_sweep.h"
#include "verification/solidity.h"

namespace qrelief {

/// Where a code should be, what it should say, and what it is to be printed with.
struct VerifyRequest {
  ProjectionFrame frame;  ///< of the code, mm in the model's frame; its normal points to the reader
  double symbolMm = 0;    ///< edge without quiet zone, on the QR plane
  std::string text;       ///< UTF-8, not empty
  Symbol symbol;          ///< the modules it should have
  Printer printer;
  std::optional<std::size_t> process;  ///< which of namedPrinters() that is; none: how it prints is not found out
  Vec3 buildUp{0, 0, 1};               ///< the printer's vertical
  double minWallMm = 0.8;
  double albedo = 0.7;  ///< of the printed material
  /// Beside the sky, and nothing else: the light that it is to read under, see DepthObjective::OneLight. None: it is to
  /// read under the sky.
  std::optional<DirectionalLight> oneLight;
  bool ranges = true;     ///< find out how far it can be tilted, blurred and so on, too
  bool isTraced = false;  ///< light is traced path by path, which takes many times as long; else lit as a height map
  int paths = 16;         ///< of traced light, from every texel of the pictures, ≥ 1
  std::size_t inheritedSelfIntersections = 0;  ///< pairs of crossing triangles that the model had before, as reported
};

/// A phone's lamp from a hand's breadth away; the sun's is half of that.
inline constexpr double kOneLightRadiusDeg = 0.5;

struct EngraveRequest;
struct EngraveResult;

/// The same code as it was carved.
VerifyRequest verifyRequestOf(const EngraveRequest& request, const EngraveResult& result);

/// A model as its file has it: scaled and welded by equal position, nothing mended.
/// @returns BadInput for a model without triangles or with coordinates that are no numbers
Result<Mesh> meshAsFound(const PolygonSoup& soup, double scaleToMm);

/// Everything that could be found out about an engraved model from the model itself; what it comes to says
/// verdict/verdict.h.
struct VerifyResult {
  SolidityReport solidity;
  CarvingProfile profile;
  std::optional<CarvedFeatures> features;  ///< if the symbol is carved there
  std::optional<SymbolGrades> grades;      ///< if it lies as it should
  ReadingSummary reading;
  std::vector<ReadingView> views;
};

/// Checks an engraved model, a bounded piece of work at a time; to cancel, stop calling. Needs no GL context: light is
/// found on the mesh itself.
class VerifyJob {
 public:
  /// @param mesh     see meshAsFound()
  /// @param readers  decoders; see ReadingSweep
  /// @returns BadUsage for a request that cannot be carried out
  static Result<std::unique_ptr<VerifyJob>> create(Mesh mesh, VerifyRequest request, std::vector<SymbolReader> readers);
  ~VerifyJob();

  /// The next piece. After an error or `done` it must not be called again.
  Result<Progress> advance();

  /// The result, once, after `done`.
  VerifyResult takeResult();

 private:
  struct State;
  explicit VerifyJob(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace qrelief
