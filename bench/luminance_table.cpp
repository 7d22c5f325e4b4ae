// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the error of the depth search's light against path-traced light, over engraved models:
//
//     qrelief_luminance_table FOLDER CENTRES.json [CELLS] [PATHS]
//
//     CENTRES.json: see bench/centres.h
//
// Each flat and each curved centre is engraved with the next of the five patterns, by two searches in turn: for
// contrast, and by the study's ReadingSearch. The pass works on the map of the model with the depths found; the path
// tracer on the engraved mesh, written to a file and read again. Compares CELLS submodules of each, drawn at random, as
// many carved as not.
//
// Then fits the interreflection of shaders/interreflection.glsl anew, to every second model, and tests it on the
// others.
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <limits>

#include "base/random.h"
#include "bench/centres.h"
#include "io/read_model.h"
#include "mesh/ray_tree.h"
#include "native/egl_context.h"
#include "pipeline/engrave.h"
#include "study/methods/reading_search.h"
#include "study/path_tracer.h"

namespace qrelief {
namespace {

constexpr int kN = kSubmodulesPerModule;
constexpr double kAlbedo = 0.7;
constexpr std::array<const char*, 5> kPatternNames = {"none", "square", "thin-plus", "diamond", "thick-plus"};
constexpr std::array<double, 3> kFitAlbedos = {0.5, kAlbedo, 0.85};

struct Cell {
  int row = 0, column = 0;  // from the quiet zone's top left
  bool carved = false;
  Received received = {};
  double luminance = 0;  // from the pass, at kAlbedo
  std::array<study::CellLight, kFitAlbedos.size()> traced = {};
  int model = 0;

  const study::CellLight& reference() const { return traced[1]; }
};

/// Returns true for the places that are engraved by the study's search ReadingSearch.
bool isByReading(int number) { return number % 4 < 2; }

EngraveRequest requestFor(const bench::Centre& centre, int number) {
  EngraveRequest request;
  request.code.text = "https://example.com/qrelief";
  request.code.symbol.version = 3;
  request.placement.centreMm = centre.positionMm;
  request.placement.sizeMode = SizeMode::Fixed;
  request.placement.sizeMm = centre.widthWithQuietZoneMm.value_or(35) * 29 / 37;
  request.code.modulePattern = static_cast<ModulePattern>(number % 5);
  request.code.finderPattern = number % 2 ? FinderPattern::Diamond : FinderPattern::ThickPlus;
  if (isByReading(number)) request.depth.contrast = study::ReadingOptions().dataContrast;
  request.depth.minWallMm = 0.4;
  request.marking.albedo = kAlbedo;
  return request;
}

Result<EngraveResult> engraveBy(const MakeSearch& makeSearch, const std::shared_ptr<const EngravableModel>& model,
                                const EngraveRequest& request) {
  CarveJob::Known known;
  known.makeSearch = makeSearch;
  auto job = CarveJob::create(model, request, known);
  QRELIEF_TRY(job);
  return runToEnd(**job);
}

/// Engraves at the suggested width, or at the largest that fits.
Result<EngraveResult> engraveAt(const std::shared_ptr<const EngravableModel>& model, EngraveRequest request,
                                int number) {
  MakeSearch makeSearch;
  if (isByReading(number))
    makeSearch = [](CarvingTarget target) {
      return std::make_unique<study::ReadingSearch>(std::move(target), study::ReadingOptions());
    };
  auto engraved = engraveBy(makeSearch, model, request);
  if (engraved) return engraved;
  request.placement.sizeMode = SizeMode::Free;
  return engraveBy(makeSearch, model, request);
}

std::vector<Cell> drawCells(const EngraveResult& engraved, int count, int model) {
  Random random(7);
  const int edge = kN * (engraved.symbol.size + 2 * kQuietZoneModules);
  std::vector<Cell> cells;
  std::array<int, 2> missing = {count - count / 2, count / 2};
  while (missing[0] + missing[1] > 0) {
    Cell cell;
    cell.row = static_cast<int>(random.below(static_cast<std::uint64_t>(edge)));
    cell.column = static_cast<int>(random.below(static_cast<std::uint64_t>(edge)));
    const int row = cell.row - kN * kQuietZoneModules, column = cell.column - kN * kQuietZoneModules;
    const int size = engraved.depths.size;
    cell.carved = row >= 0 && column >= 0 && row < size && column < size && engraved.depths.depth(row, column) > 0;
    if (missing[cell.carved]-- <= 0) {
      missing[cell.carved] = 0;
      continue;
    }
    cell.received = engraved.received.at(cell.row, cell.column);
    cell.luminance = engraved.luminance.at(cell.row, cell.column);
    cell.model = model;
    cells.push_back(cell);
  }
  return cells;
}

void trace(const EngraveResult& engraved, int paths, std::vector<Cell>& cells) {
  const RayTree tree(engraved.mesh);
  const double edge = engraved.depths.submoduleMm();
  std::vector<study::SeenCell> seen;
  for (const Cell& cell : cells) {
    const Vec2 corner = engraved.depths.corner(cell.row - kN * kQuietZoneModules, cell.column - kN * kQuietZoneModules);
    seen.push_back({{corner.x, corner.y - edge}, {corner.x + edge, corner.y}});
  }
  for (std::size_t a = 0; a < kFitAlbedos.size(); ++a) {
    const auto traced = study::traceCells(tree, engraved.placement.frame, seen,
                                          {.paths = paths, .albedo = kFitAlbedos[a], .seed = a + 1});
    for (std::size_t i = 0; i < cells.size(); ++i) cells[i].traced[a] = traced[i];
  }
}

/// Mean of the absolute values, and their 99th percentile.
template <class Value>
std::string summary(const std::vector<Cell>& cells, Value value) {
  std::vector<double> values;
  double sum = 0;
  for (const Cell& cell : cells) {
    values.push_back(std::abs(value(cell)));
    sum += values.back();
  }
  if (values.empty()) return "–";
  std::sort(values.begin(), values.end());
  const double count = static_cast<double>(values.size());
  return fmt::format("{:.4f} / {:.4f}", sum / count, values[static_cast<std::size_t>(std::ceil(0.99 * count)) - 1]);
}

std::vector<Cell> carvedOnes(const std::vector<Cell>& cells) {
  std::vector<Cell> carved;
  std::copy_if(cells.begin(), cells.end(), std::back_inserter(carved), [](const Cell& cell) { return cell.carved; });
  return carved;
}

void printRow(const std::string& name, const std::vector<Cell>& cells) {
  fmt::print("| {} |", name);
  for (const std::vector<Cell>& some : {cells, carvedOnes(cells)}) {
    fmt::print(" {} |", summary(some, [](const Cell& c) { return c.received.sky - c.reference().visibility.mean; }));
    fmt::print(" {} |", summary(some, [](const Cell& c) { return c.luminance - c.reference().luminance.mean; }));
  }
  fmt::print(" {} |", summary(cells, [](const Cell& c) { return c.reference().visibility.standardError; }));
  fmt::print(" {} |\n", summary(cells, [](const Cell& c) { return c.reference().luminance.standardError; }));
  std::fflush(stdout);
}

/// Coefficients of interreflection.glsl: the walls reflect wall / (1 - bounces·albedo)·√visibility, the surface
/// reflects `surface`.
struct Factors {
  double wall = 0, bounces = 0, surface = 0;
};

double reflectedBy(const Factors& f, const Received& r, double albedo) {
  const double sky = static_cast<double>(r.sky), pastWalls = static_cast<double>(r.pastWalls);
  const double wall = f.wall / (1 - f.bounces * albedo) * std::sqrt(sky);
  return albedo * ((1 - pastWalls) * wall + (pastWalls - sky) * f.surface);
}

/// Fits by least squares over every second model: linear in `wall` and `surface`, tried for every hundredth of
/// `bounces`.
Factors fitted(const std::vector<Cell>& cells) {
  Factors best;
  double least = std::numeric_limits<double>::infinity();
  for (int hundredths = 0; hundredths < 100; ++hundredths) {
    const double bounces = hundredths / 100.0;
    double xx = 0, xy = 0, yy = 0, xt = 0, yt = 0;
    for (const Cell& cell : cells) {
      if (cell.model % 2) continue;
      for (std::size_t a = 0; a < kFitAlbedos.size(); ++a) {
        const double x = reflectedBy({1, bounces, 0}, cell.received, kFitAlbedos[a]);
        const double y = reflectedBy({0, bounces, 1}, cell.received, kFitAlbedos[a]);
        const double target = cell.traced[a].luminance.mean - cell.traced[a].visibility.mean;
        xx += x * x;
        xy += x * y;
        yy += y * y;
        xt += x * target;
        yt += y * target;
      }
    }
    const double determinant = xx * yy - xy * xy;
    const double wall = (xt * yy - yt * xy) / determinant, surface = (yt * xx - xt * xy) / determinant;
    const double squares = -wall * xt - surface * yt;  // without the squares of the target
    if (squares < least) {
      least = squares;
      best = {wall, bounces, surface};
    }
  }
  return best;
}

void printFit(const std::vector<Cell>& cells) {
  const Factors f = fitted(cells);
  fmt::print(
      "\ninterreflection fitted to the models 1, 3, 5 …: wall = {:.3f} / (1 - {:.2f}·albedo)·√visibility, "
      "surface = {:.3f}\n\n",
      f.wall, f.bounces, f.surface);
  fmt::print("| luminance error (mean / 99 %) at albedo | {} | {} | {} |\n|---|---|---|---|\n", kFitAlbedos[0],
             kFitAlbedos[1], kFitAlbedos[2]);
  for (const int parity : {0, 1}) {
    std::vector<Cell> some;
    std::copy_if(cells.begin(), cells.end(), std::back_inserter(some),
                 [&](const Cell& cell) { return cell.carved && cell.model % 2 == parity; });
    fmt::print("| carved submodules of the {} |", parity == 0 ? "models fitted to" : "other models");
    for (std::size_t a = 0; a < kFitAlbedos.size(); ++a)
      fmt::print(" {} |", summary(some, [&](const Cell& cell) {
                   const double luminance =
                       static_cast<double>(cell.received.sky) + reflectedBy(f, cell.received, kFitAlbedos[a]);
                   return luminance - cell.traced[a].luminance.mean;
                 }));
    fmt::print("\n");
  }
}

int run(const std::string& folder, const std::string& centres, int cellCount, int paths) {
  const auto context = EglContext::create();
  if (!context) return bench::failed("EGL", context.error());
  fmt::print("Error per submodule, mean / 99th percentile; {} submodules a row, half of them carved; {} paths each\n\n",
             cellCount, paths);
  fmt::print(
      "| engraved | visibility | luminance | visibility, carved | luminance, carved "
      "| tracer's standard error: visibility | luminance |\n|---|---|---|---|---|---|---|\n");
  std::vector<Cell> all;
  int number = 0;
  const auto visit = [&](const std::shared_ptr<const EngravableModel>& model, const bench::Centre& centre) -> Status {
    const EngraveRequest request = requestFor(centre, number);
    const auto engraved = engraveAt(model, request, number++);
    QRELIEF_TRY(engraved);
    std::vector<Cell> cells = drawCells(*engraved, cellCount, centre.modelNumber);
    trace(*engraved, paths, cells);
    printRow(fmt::format("{}, {}", centre.name, kPatternNames[static_cast<std::size_t>(*request.code.modulePattern)]),
             cells);
    all.insert(all.end(), cells.begin(), cells.end());
    return {};
  };
  const int status = bench::forEachCentre(folder, centres, {"flat", "curved"}, visit);
  printRow("all", all);
  printFit(all);
  return status;
}

}  // namespace
}  // namespace qrelief

int main(int argc, char** argv) {
  if (argc < 3) {
    fmt::print(stderr, "usage: {} FOLDER CENTRES.json [CELLS] [PATHS]\n", argv[0]);
    return 2;
  }
  return qrelief::run(argv[1], argv[2], argc > 3 ? std::atoi(argv[3]) : 200, argc > 4 ? std::atoi(argv[4]) : 2048);
}
