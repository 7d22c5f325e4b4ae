// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "carving/mark.h"
#include "label/label_layout.h"
#include "light/directional_light.h"
#include "mesh/polygon_soup.h"
#include "mesh/ray_tree.h"
#include "verification/carving_profile.h"
#include "verification/grades.h"
#include "verification/printability.h"
#include "verification/reading_sweep.h"
#include "verification/solidity.h"

namespace qrelief {

/// The expected code, its place, and the printer.
struct VerifyRequest {
  ProjectionFrame frame;  ///< frame of the code, mm in the model's coordinates; its normal points to the viewer
  double symbolMm = 0;    ///< edge without the quiet zone, on the QR plane
  std::string text;       ///< UTF-8, not empty
  Symbol symbol;          ///< the expected modules
  Printer printer;
  std::optional<std::size_t> process;  ///< index of the printer in namedPrinters(); none: the print is not simulated
  Vec3 buildUp{0, 0, 1};               ///< the printer's vertical
  std::optional<Vec3> lowMm = {};      ///< lower corner of the bounding box of the item with the code; none: unknown
  double minWallMm = 0.8;
  double albedo = 0.7;       ///< reflectance of the model's material
  Mark mark = Mark::Shadow;  ///< Inlay, Paint: `symbol` says which modules are dark, as meshes have no colours
  double markDepthMm = 0;    ///< Inlay: depth along the rays, > 0
  double darkReflectance = Ink{}.dark;  ///< Inlay, Paint: of the second colour
  LabelOptions label;  ///< Inlay, Paint: in the second colour, too; only the print shows it. Alone: see isText()
  std::vector<DirectionalLight>
      lamps;               ///< in addition to the sky, under which the code must decode; at most kMaxLights
  bool needsLamp = false;  ///< it reads reliably under its only lamp alone, see DepthObjective::OneLight
  bool ranges = true;      ///< also find the ranges of tilt, blur and so on in which it decodes
  bool isTraced = false;   ///< trace light path by path, which takes many times as long; else light it as a height map
  int paths = 16;          ///< paths from every texel of the pictures, for traced light, ≥ 1
  std::size_t inheritedSelfIntersections = 0;  ///< reported pairs of crossing triangles before carving

  /// Returns the two materials of Mark::Inlay and Mark::Paint.
  Ink ink() const { return {darkReflectance, albedo}; }

  /// Returns true for a text in place of a code. Only the solid is then checked: there is nothing to decode.
  bool isText() const { return label.isAlone; }
};

/// Angular radius of a phone's lamp a hand's breadth away; the sun's is half of it.
inline constexpr double kLampRadiusDeg = 0.5;

struct EngraveRequest;
struct EngraveResult;

/// Returns the request to verify a code as it was carved.
VerifyRequest verifyRequestOf(const EngraveRequest& request, const EngraveResult& result);

/// Returns a model's mesh without repairs: only scaled and welded by equal position.
/// @returns BadInput if the model has no triangles or a coordinate is not a number
Result<Mesh> meshAsFound(const PolygonSoup& soup, double scaleToMm);

/// Looks for the code in a 3MF file whose item is turned and moved to the pose on the printer
/// (io/three_mf/write_3mf.h, io/three_mf/rewrite_3mf.h). Tries each item of the file, as turned and as not, and changes
/// the frame and the vertical to the file's where the code's modules are carved best, or at least lie on the surface.
/// Cost: O(T log T).
/// @param mesh    the file's, mm, its triangles as in the file
/// @param source  the file; null: it is one item
void findInPose(VerifyRequest& request, const Mesh& mesh, const ThreeMfSource* source);

/// All measurements of an engraved model; verdict/verdict.h draws the conclusion.
struct VerifyResult {
  SolidityReport solidity;
  CarvingProfile profile;
  std::optional<CarvedFeatures> features;  ///< if the symbol is carved at the expected place
  std::optional<SymbolGrades> grades;      ///< if the symbol lies as expected
  ReadingSummary reading;
  std::vector<ReadingView> views;
};

/// Checks an engraved model, a bounded piece of work at a time; to cancel, stop calling advance(). Needs no GL context,
/// as light is computed on the mesh itself.
class VerifyJob {
 public:
  /// @param mesh     see meshAsFound()
  /// @param decoders  see ReadingSweep
  /// @returns BadUsage for an impossible request
  static Result<std::unique_ptr<VerifyJob>> create(Mesh mesh, VerifyRequest request, std::vector<Decoder> decoders);
  ~VerifyJob();

  /// Returns the next stage and the fraction of the job that is done.
  Progress progress() const;

  /// Does the next piece of work. Do not call it again after an error or `done`.
  Result<Progress> advance();

  /// Returns the result. Call it once, after `done`.
  VerifyResult takeResult();

 private:
  struct State;
  explicit VerifyJob(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace qrelief
