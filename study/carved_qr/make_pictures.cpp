// SPDX-License-Identifier: GPL-3.0-or-later
// CarvedQR: pictures of carved codes with ground truth, for developers of decoders. script/carved-qr runs it; README.md
// in this folder describes the output.
//
// Every carving is drawn from its own seed: model, text, patterns, depth, size, process and pose. It is pictured as
// designed and as printed, each kPicturesOfASurface times with its own camera and light. A carving is done once its
// part of the truth is written, so an interrupted run resumes there, and any process may make any carving.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <numbers>

#include "base/random.h"
#include "messages/sentences.h"
#include "native/egl_context.h"
#include "native/files.h"
#include "native/png_file.h"
#include "pipeline/printed_view.h"
#include "study/carved_surface.h"
#include "study/methods/by_engine.h"
#include "study/printed_rays.h"
#include "study/study_context.h"
#include "verification/baked_light.h"
#include "verification/reader_view.h"
#include "verification/reading_sweep.h"
#include "verification/resample.h"

namespace qrelief::study {
namespace {

using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr int kPicturesOfASurface = 10, kPaths = 8;

/// Edge of a picture in modules: symbol and most of the quiet zone fit at every roll.
int edgeModules(int modules) { return modules + 16; }

/// Draws one of some values, all equally likely.
template <class T, std::size_t Count>
T drawn(Random& random, const std::array<T, Count>& values) {
  return values[random.below(Count)];
}

std::string drawnText(Random& random) {
  constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyz0123456789-";
  std::string text = "https://example.org/";
  for (auto count = 1 + random.below(40); count > 0; --count) text += kLetters[random.below(kLetters.size())];
  return text;
}

Result<EngraveRequest> drawnRequest(Random& random, StudyContext& context, const std::string& model) {
  auto request = context.usualRequest(model);
  if (!request) return request;
  request->code.text = drawnText(random);
  request->code.symbol = {};
  request->code.symbol.errorCorrection =
      drawn(random, std::array{ErrorCorrection::L, ErrorCorrection::M, ErrorCorrection::Q, ErrorCorrection::H});
  if (random.below(2) == 0) {  // otherwise the defaults stay
    request->code.modulePattern = static_cast<ModulePattern>(random.below(5));
    request->code.finderPattern = static_cast<FinderPattern>(random.below(5));
  }
  request->depth.contrast = random.uniform(0.15, 0.75);
  request->depth.carveFor = random.below(2) == 0 ? CarveFor::Design : CarveFor::Print;
  request->print.process = random.below(namedPrinters().size());
  request->print.printer = namedPrinters()[*request->print.process].printer;
  request->print.buildUp.pose = random.below(2) == 0 ? BuildPose::CodeUp : BuildPose::CodeUpright;
  request->marking.albedo = random.uniform(0.3, 0.85);
  request->placement.rotateDeg = random.uniform(-180, 180);
  const auto symbol = encodeSymbol(request->code.text, request->code.symbol);
  QRELIEF_TRY(symbol);
  request->placement.sizeMode = SizeMode::Oriented;
  request->placement.maxSizeMm = random.uniform(0.5, 1.6) * symbol->size;
  return request;
}

Lamp drawnLamp(Random& random, const ProjectionFrame& frame) {
  const DirectionalLight light{random.uniform(0, 360), random.uniform(15, 75), random.uniform(0.1, 1)};
  return lampOf(light, frame, random.uniform(0, 20));
}

/// Rounds to three decimals, as the truth has numbers.
double rounded(double x) { return std::round(1000 * x) / 1000; }

/// A carving and the data that its pictures need.
struct Carving {
  StudyPlacement spot;
  CarvedCode code;
  Lamp lamp;
  Json truth;  ///< common to all its pictures
};

/// Returns the corners of the symbol in a picture, clockwise from the symbol's top left, pixels from the picture's top
/// left.
/// @param middle  of the camera's view, in the same pixels
Json cornersIn(const Carving& carving, const RayTree& uncarved, const ProjectionFrame& camera, double pixelsPerMm,
               Vec2 middle) {
  const ProjectionFrame& frame = carving.spot.placement.frame;
  const double half = carving.spot.placement.symbolMm / 2;
  Json corners = Json::array();
  for (const Vec2 corner : {Vec2(-half, half), Vec2(half, half), Vec2(half, -half), Vec2(-half, -half)}) {
    const auto hit = uncarved.firstHit(frame.eye(), frame.rayDirection(corner));
    const Vec2 seen = camera.project(hit ? hit->position : frame.onPlane(corner)) * pixelsPerMm;
    corners.push_back({rounded(middle.x + seen.x), rounded(middle.y - seen.y)});
  }
  return corners;
}

/// Takes one picture. @returns its line of the truth
Result<Json> takePicture(Random& random, const Carving& carving, const BakedLight& light, const RayTree& uncarved,
                         const std::string& folder, const std::string& name) {
  const ProjectionFrame& frame = carving.spot.placement.frame;
  const int modules = carving.code.symbol.size;
  const double moduleMm = carving.spot.placement.moduleMm;
  const bool isTilted = random.below(2) == 0, isTurned = random.below(2) == 0, isLit = random.below(2) == 0;
  const double tiltDeg = isTilted ? random.uniform(2, 45) : 0, azimuthDeg = isTilted ? random.uniform(0, 360) : 0;
  const double rollDeg = 90.0 * static_cast<double>(isTurned ? random.below(4) : 0) + random.uniform(-20, 20);
  const double pixels = 2.5 * std::pow(3.2, random.uniform()), blur = random.uniform(0.05, 0.4);  // up to 8 pixels
  CameraOptions camera{.blurPx = blur * pixels,
                       .noise = random.uniform(0.003, 0.04),
                       .strayLight = kStrayLight,
                       .exposure = random.uniform(0.5, 1),
                       .seed = random.next()};
  const ProjectionFrame eye =
      turned(tiltDeg > 0 ? tilted(frame, tiltDeg, azimuthDeg) : frame, rollDeg * std::numbers::pi / 180);
  const LinearPicture seen = light.picture(eye, kBakedPixels * edgeModules(modules), moduleMm / kBakedPixels);
  BottomUp<float> luminance = seen.sky;
  for (std::size_t i = 0; isLit && i < luminance.size(); ++i) luminance[i] += seen.added[i];
  const double coarser = kBakedPixels / pixels;
  const GreyImage picture = photograph(resampled(luminance, coarser), camera);
  const auto png = encodePng(picture);
  QRELIEF_TRY(png);
  QRELIEF_TRY(writeFileAtomically(folder + "/" + name, *png));
  Json line = {{"picture", name}};
  line.update(carving.truth);
  line["lamp"] = isLit;
  line["tiltDeg"] = rounded(tiltDeg);
  line["azimuthDeg"] = rounded(azimuthDeg);
  line["rollDeg"] = rounded(rollDeg);
  line["pixelsPerModule"] = rounded(pixels);
  line["blurModules"] = rounded(blur);
  line["noise"] = rounded(camera.noise);
  line["exposure"] = rounded(camera.exposure);
  // The grid of sensor cells begins at the lower left of the visible square. Leftovers at its far ends that do not fill
  // a cell are dropped.
  const double half = luminance.columns() / coarser / 2;
  line["corners"] = cornersIn(carving, uncarved, eye, pixels / moduleMm, {half, picture.width - half});
  return line;
}

Result<Carving> carve(Random& random, StudyContext& context) {
  const std::string name = StudyContext::models()[random.below(StudyContext::models().size())];
  const auto model = context.model(name);
  QRELIEF_TRY(model);
  const auto request = drawnRequest(random, context, name);
  QRELIEF_TRY(request);
  auto spot = findSpot(name, *model, *request);
  QRELIEF_TRY(spot);
  auto code = carveByEngine(*spot, *request);
  QRELIEF_TRY(code);
  Carving carving{std::move(*spot), std::move(*code), {}, {}};
  carving.lamp = drawnLamp(random, carving.spot.placement.frame);
  Json matrix = Json::array();
  for (int row = 0; row < carving.code.symbol.size; ++row) {
    std::string modules;
    for (int column = 0; column < carving.code.symbol.size; ++column)
      modules += carving.code.symbol.isDark(row, column) ? '1' : '0';
    matrix.push_back(std::move(modules));
  }
  carving.truth = {{"text", request->code.text},
                   {"version", carving.code.symbol.version},
                   {"errorCorrection", errorCorrectionName(carving.code.symbol.errorCorrection)},
                   {"mask", carving.code.symbol.mask},
                   {"matrix", matrix},
                   {"model", name},
                   {"moduleMm", rounded(carving.spot.placement.moduleMm)},
                   {"modules", modulePatternName(*request->code.modulePattern)},
                   {"finders", finderPatternName(*request->code.finderPattern)},
                   {"meanDepthMm", rounded(summarise(carving.code.depths).meanMm)},
                   {"surface", "designed"},
                   {"process", nullptr},
                   {"pose", nullptr}};
  return carving;
}

/// Takes the pictures of one surface. @param lines  receives the truth
Status picture(Random& random, const Carving& carving, const RaySurface& surface, const std::string& folder,
               const std::string& names, Json& lines) {
  const Placement& placement = carving.spot.placement;
  BakedLight light(surface, placement.frame,
                   {.texelMm = placement.moduleMm / kBakedPixels,
                    .texels = kBakedPixels * edgeModules(carving.code.symbol.size),
                    .paths = kPaths,
                    .albedo = carving.spot.request.marking.surfaceAlbedo(),
                    .lamps = {carving.lamp}});
  while (!light.bakeRows(16)) continue;
  light.smooth();
  const RayTree uncarved(carving.spot.model->prepared.mesh);
  for (int i = 0; i < kPicturesOfASurface; ++i) {
    auto line = takePicture(random, carving, light, uncarved, folder, fmt::format("{}-{}.png", names, i));
    QRELIEF_TRY(line);
    lines.push_back(std::move(*line));
  }
  return {};
}

/// Takes the pictures of one carving. @returns lines of the truth; none if the drawn carving is impossible
Result<std::string> makeCarving(std::uint64_t seed, const std::string& name, StudyContext& context,
                                const std::string& folder) {
  Random random(seed);
  auto carving = carve(random, context);
  if (!carving) {
    fmt::print(stderr, "{} is left out: {}\n", name, sentence(carving.error().message));
    return std::string();
  }
  Json lines = Json::array();
  const auto surface = CarvedSurface::make(carving->spot, carving->code.depths);
  QRELIEF_TRY(surface);
  QRELIEF_TRY(picture(random, *carving, surface->tree(), folder, name + "-designed", lines));
  const EngraveRequest& request = carving->spot.request;
  const Placement& placement = carving->spot.placement;
  const auto process = processOf(request.print.printer);
  QRELIEF_TRY(process);
  const double edge = placement.moduleMm * edgeModules(carving->code.symbol.size);
  auto printed = printSurface(surface->mesh(), {.process = *process,
                                                .frame = placement.frame,
                                                .extentMm = edge,
                                                .buildUp = request.print.buildUp.resolve(placement.frame)});
  QRELIEF_TRY(printed);
  carving->truth["surface"] = "printed";
  carving->truth["process"] = namedPrinters()[*request.print.process].name;
  carving->truth["pose"] = buildPoseName(request.print.buildUp.pose);
  QRELIEF_TRY(picture(random, *carving, PrintedRays(*printed), folder, name + "-printed", lines));
  std::string text;
  for (const Json& line : lines) text += line.dump() + "\n";
  return text;
}

int failed(const std::string& what, const Error& error) {
  fmt::print(stderr, "{}: {}\n", what, sentenceAndHint(error.message));
  return 1;
}

int run(int argc, char** argv) {
  CLI::App app("Makes CarvedQR, pictures of carved codes with truth");
  std::string folder, samples;
  std::size_t carvings = 110, first = 0, step = 1;
  std::uint64_t seed = 1;
  app.add_option("FOLDER", folder, "where it is written")->required();
  app.add_option("--samples", samples, "folder of the page's sample models")->required();
  app.add_option("--carvings", carvings, "how many codes are drawn; each gives 20 pictures")->capture_default_str();
  app.add_option("--seed", seed, "of all draws")->capture_default_str();
  app.add_option("--first", first, "begin with this carving")->capture_default_str();
  app.add_option("--step", step, "make every so many-th, as one of several processes")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  const auto gl = EglContext::create();
  if (!gl) return failed("EGL", gl.error());
  StudyContext context(samples);
  fs::create_directories(folder + "/pictures");
  fs::create_directories(folder + "/truth");
  for (std::size_t k = first; k < carvings; k += std::max<std::size_t>(1, step)) {
    const std::string name = fmt::format("{:05}", k), part = fmt::format("{}/truth/{}.jsonl", folder, name);
    if (fs::exists(part)) continue;
    const auto lines = makeCarving(seed * 1000003 + k, name, context, folder + "/pictures");
    if (!lines) return failed(name, lines.error());
    if (const Status written = writeFileAtomically(part, *lines); !written) return failed(part, written.error());
  }
  return 0;
}

}  // namespace
}  // namespace qrelief::study

int main(int argc, char** argv) { return qrelief::study::run(argc, argv); }
