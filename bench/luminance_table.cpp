// SPDX-License-Identifier: GPL-3.0-or-later
// How far the luminance that the depth search sees is from path traced light, over engraved models:
//
//     qrelief_luminance_table FOLDER CENTRES.json [CELLS] [PATHS] [FILE.csv]
//
//     CENTRES.json: {"model.stl": {"scaleToMm": 1, "picks": {"KIND": {"pointFileUnits": [x, y, z],
//                                                                     "widthWithQuietZoneMm": 35}}}}
//
// Each flat and each curved centre is engraved with the next of five patterns, half of them with each objective. The
// pass works on the map of the model and the depths found; the path tracer on the engraved mesh, as written to a file
// and read again. Of each, CELLS submodules drawn at random are compared, as many carved as not.
#include <algorithm>
#include <array>
#include <chrono>
#include <fmt/format.h>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/random.h"
#include "io/read_model.h"
#include "native/egl_context.h"
#include "pipeline/engrave.h"
#include "render/luminance_pass.h"
#include "verification/path_tracer.h"

namespace qrelief {
namespace {

using Json = nlohmann::json;
constexpr int kN = kSubmodulesPerModule;

struct Case {
  std::string name;
  std::shared_ptr<const EngravableModel> model;
  EngraveRequest request;
};

Result<std::shared_ptr<const EngravableModel>> load(const std::string& path, double scaleToMm) {
  std::ifstream stream(path, std::ios::binary);
  const std::vector<std::uint8_t> bytes(std::istreambuf_iterator<char>(stream), {});
  const auto soup = readModel(bytes, path);
  if (!soup) return tl::unexpected(soup.error());
  auto prepared = prepareModel(*soup, {.scaleToMm = scaleToMm});
  if (!prepared) return tl::unexpected(prepared.error());
  if (const Status engravable = prepared->engravable(); !engravable) return tl::unexpected(engravable.error());
  return EngravableModel::upload(std::move(*prepared));
}

struct Cell {
  int row = 0, column = 0;  // from the quiet zone's top left
  bool carved = false;
  double depthMm = 0;
  double visibility = 0, open = 0, luminance = 0;  // of the pass
  CellLight traced = {};
};

int failed(const std::string& what, const Error& error) {
  fmt::print(stderr, "{}: {} ({})\n", what, error.message, error.hint);
  return 1;
}

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<Cell> drawCells(const EngraveResult& engraved, int count) {
  Random random(7);
  const int edge = kN * (engraved.symbol.size + 2 * kQuietZoneModules);
  std::vector<Cell> cells;
  int wanted[2] = {count - count / 2, count / 2};
  while (wanted[0] + wanted[1] > 0) {
    Cell cell{static_cast<int>(random.below(edge)), static_cast<int>(random.below(edge))};
    const int row = cell.row - kN * kQuietZoneModules, column = cell.column - kN * kQuietZoneModules;
    if (row >= 0 && column >= 0 && row < engraved.depths.size && column < engraved.depths.size)
      cell.depthMm = engraved.depths.depth(row, column);
    cell.carved = cell.depthMm > 0;
    if (wanted[cell.carved] == 0) continue;
    --wanted[cell.carved];
    cells.push_back(cell);
  }
  return cells;
}

struct Summary {
  double meanAbsolute = 0, p99 = 0, bias = 0;
};

template <class Difference>
Summary summary(const std::vector<Cell>& cells, int carved, Difference difference) {
  std::vector<double> values;
  Summary s;
  for (const Cell& cell : cells) {
    if (carved >= 0 && cell.carved != (carved == 1)) continue;
    values.push_back(std::abs(difference(cell)));
    s.bias += difference(cell);
    s.meanAbsolute += values.back();
  }
  const double n = static_cast<double>(values.size());
  std::sort(values.begin(), values.end());
  s.bias /= n;
  s.meanAbsolute /= n;
  s.p99 = values[static_cast<std::size_t>(std::ceil(0.99 * n)) - 1];
  return s;
}

void printRow(const std::string& name, const std::vector<Cell>& cells) {
  fmt::print("| {} |", name);
  for (const int carved : {1, 0}) {
    const Summary v = summary(cells, carved, [](const Cell& c) { return c.visibility - c.traced.visibility.mean; });
    const Summary l = summary(cells, carved, [](const Cell& c) { return c.luminance - c.traced.luminance.mean; });
    fmt::print(" {:.4f} {:.4f} {:+.4f} | {:.4f} {:.4f} {:+.4f} |", v.meanAbsolute, v.p99, v.bias, l.meanAbsolute,
               l.p99, l.bias);
  }
  const Summary se = summary(cells, -1, [](const Cell& c) { return c.traced.visibility.standardError; });
  const Summary sl = summary(cells, -1, [](const Cell& c) { return c.traced.luminance.standardError; });
  fmt::print(" {:.4f} {:.4f} | {:.4f} {:.4f} |\n", se.meanAbsolute, se.p99, sl.meanAbsolute, sl.p99);
  std::fflush(stdout);
}

int run(const std::string& folder, const std::string& centres, int cellCount, int paths, const std::string& csv) {
  const auto context = EglContext::create();
  if (!context) return failed("EGL", context.error());
  const auto geometry = GeometryPass::create();
  if (!geometry) return failed("shaders", geometry.error());
  std::ifstream stream(centres);
  const Json models = Json::parse(stream, nullptr, false);
  if (!models.is_object()) return failed(centres, {ErrorCode::BadInput, "not a JSON object", ""});
  std::ofstream dump;
  if (!csv.empty()) dump.open(csv);
  std::vector<Cell> all;
  int number = 0, status = 0;
  const char* only = std::getenv("ONLY");
  for (const auto& [file, entry] : models.items()) {
    if (file.find("igea") != std::string::npos || file.find("gears") != std::string::npos) continue;
    if (only && file.find(only) == std::string::npos) { number += 2; continue; }
    const double scale = entry["scaleToMm"].get<double>();
    const auto model = load(folder + "/" + file, scale);
    if (!model) { status = failed(file, model.error()); continue; }
    for (const char* kind : {"flat", "curved"}) {
      if (!entry["picks"].contains(kind)) continue;
      const Json& pick = entry["picks"][kind];
      const auto point = pick["pointFileUnits"].get<std::array<double, 3>>();
      Case c;
      c.model = *model;
      c.request.text = "https://example.com/qrelief";
      c.request.symbol.version = 3;
      c.request.placement.centreMm = Vec3(point[0], point[1], point[2]) * scale;
      c.request.placement.sizeMode = SizeMode::Fixed;
      c.request.placement.sizeMm = pick["widthWithQuietZoneMm"].get<double>() * 29 / 37;
      c.request.modulePattern = static_cast<ModulePattern>(number % 5);
      c.request.finderPattern = number % 2 ? FinderPattern::Diamond : FinderPattern::ThickPlus;
      c.request.objective = number % 4 < 2 ? DepthObjective::Reading : DepthObjective::Contrast;
      c.name = fmt::format("{} {} p{}f{}o{}", file.substr(0, file.find('.')), kind, number % 5, number % 2, number % 4 < 2 ? "r" : "c");
      ++number;
      auto engraved = engrave(c.model, c.request);
      if (!engraved) {
        c.request.placement.sizeMode = SizeMode::Free;
        engraved = engrave(c.model, c.request);
      }
      if (!engraved) { status = failed(c.name, engraved.error()); continue; }
      std::vector<Cell> cells = drawCells(*engraved, cellCount);
      const int edge = kN * (engraved->symbol.size + 2 * kQuietZoneModules);
      for (Cell& cell : cells) {
        const auto i = static_cast<std::size_t>(cell.row * edge + cell.column);
        cell.visibility = engraved->received[i].sky;
        cell.open = engraved->received[i].skyUncarved;
        cell.luminance = engraved->luminance[i];
      }
      const RayTree tree(engraved->mesh);
      std::vector<SeenCell> seen;
      const double h = engraved->depths.submoduleMm();
      for (const Cell& cell : cells) {
        const Vec2 corner = engraved->depths.corner(cell.row - kN * kQuietZoneModules, cell.column - kN * kQuietZoneModules);
        seen.push_back({{corner.x, corner.y - h}, {corner.x + h, corner.y}});
      }
      const auto start = std::chrono::steady_clock::now();
      if (paths > 0) {
        const auto traced = traceCells(tree, engraved->placement.frame, seen, {.paths = paths});
        for (std::size_t i = 0; i < cells.size(); ++i) cells[i].traced = traced[i];
      }
      fmt::print(stderr, "{}: traced {:.1f} s, symbol {:.1f} mm mean {:.2f}\n", c.name, secondsSince(start), engraved->placement.symbolMm, summarise(engraved->depths).meanMm);
      printRow(c.name, cells);
      all.insert(all.end(), cells.begin(), cells.end());
      if (dump)
        for (const Cell& cell : cells)
          dump << fmt::format("{},{},{},{},{:.4f},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f}\n", c.name, cell.row, cell.column, cell.carved, cell.depthMm,
                              cell.visibility, cell.luminance, cell.traced.visibility.mean, cell.traced.visibility.standardError, cell.traced.luminance.mean, cell.traced.luminance.standardError, cell.open);
      dump.flush();
    }
  }
  if (!all.empty()) printRow("all", all);
  return status;
}

}  // namespace
}  // namespace qrelief

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  return qrelief::run(argv[1], argv[2], argc > 3 ? std::atoi(argv[3]) : 60, argc > 4 ? std::atoi(argv[4]) : 1024,
                      argc > 5 ? argv[5] : "");
}
