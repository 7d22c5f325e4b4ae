// SPDX-License-Identifier: GPL-3.0-or-later
// Counts the work of the depth search with shaders: pass by pass with a solver on the CPU, and in batches on the GPU.
// The counts do not depend on the device, so a software renderer will do.
//
//     qrelief_search_passes_bench      a plate, with codes of 29 × 29 and 57 × 57 modules
#include <algorithm>
#include <cstdio>
#include <fmt/format.h>

#include "depth/fast_search.h"
#include "depth/shader_search.h"
#include "gl/pass_timings.h"
#include "mesh/prepare.h"
#include "messages/sentences.h"
#include "native/egl_context.h"
#include "pipeline/depth_search_run.h"
#include "pipeline/engrave.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

constexpr int kTexelsPerCell = 4;  // LuminanceSampling{}.computedTexels²

struct Counts {
  int passes = 0, readBacks = 0, sweeps = 0;
  std::size_t carved = 0, measured = 0;  // floors, in all passes
  double meanMm = 0;
};

/// Counts the floors that a solver requests.
class Counted final : public DepthSolver {
 public:
  Counted(CarvingTarget target, const FastSearchOptions& options, std::size_t& measured)
      : carved_(static_cast<std::size_t>(std::count(target.mask->begin(), target.mask->end(), 1))),
        measured_(measured),
        solver_(std::move(target), options) {}

  void update(const Grid<double>& luminance) override {
    measured_ += solver_.due().empty() ? carved_ : solver_.due().size();
    solver_.update(luminance);
  }
  std::span<const std::uint32_t> due() const override { return solver_.due(); }
  bool finished() const override { return solver_.finished(); }
  int iterations() const override { return solver_.iterations(); }
  double doneFraction() const override { return solver_.doneFraction(); }
  const DepthField& depths() const override { return solver_.depths(); }
  std::size_t limitedCount() const override { return solver_.limitedCount(); }
  std::size_t unfinishedCount() const override { return solver_.unfinishedCount(); }

 private:
  std::size_t carved_;
  std::size_t& measured_;
  FastSearch solver_;
};

/// Counts the floors that moved between two passes, or touch one that did.
std::size_t dueBetween(const SearchRecord& record, std::size_t pass, int size) {
  std::vector<char> moved(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), 0);
  for (std::size_t k = 0; k < record.carved.size(); ++k)
    moved[record.carved[k]] = record.passes[pass].depthMm[k] != record.passes[pass - 1].depthMm[k];
  std::size_t count = 0;
  for (const std::uint32_t i : record.carved) {
    bool due = false;
    for (int near = 0; near < 9; ++near) {
      const int row = static_cast<int>(i) / size - 1 + near / 3, column = static_cast<int>(i) % size - 1 + near % 3;
      if (row >= 0 && column >= 0 && row < size && column < size)
        due = due || moved[static_cast<std::size_t>(row * size + column)];
    }
    count += due;
  }
  return count;
}

Result<Counts> count(const std::shared_ptr<const EngravableModel>& model, EngraveRequest request, bool onGpu) {
  Counts counts;
  request.depth.recordSearch = true;
  CarveJob::Known known;
  known.device = Device::Gpu;
  if (!onGpu)
    known.makeSearch = [&](CarvingTarget target) {
      return std::make_unique<Counted>(std::move(target), fastSearchOptions(request), counts.measured);
    };
  auto job = CarveJob::create(model, request, known);
  QRELIEF_TRY(job);
  gl::PassTimings timings(false);
  for (bool done = false; !done;) {
    const bool searches = (*job)->progress().stage.code == "finding-depth";
    if (searches)
      timings.listen();
    else
      timings.stopListening();
    const auto progress = (*job)->advance();
    QRELIEF_TRY(progress);
    done = progress->done;
  }
  for (const gl::PassTime& time : timings.times()) {
    if (time.name == "reading back") counts.readBacks = time.count;
    if (time.name == "solving") counts.sweeps = time.count * ShaderSearch::kSweepsPerPass;
  }
  const EngraveResult result = (*job)->takeResult();
  counts.passes = result.searchIterations;
  counts.carved = result.search.carved.size();
  counts.meanMm = summarise(result.depths).meanMm;
  if (onGpu)
    for (std::size_t pass = 0; pass < result.search.passes.size(); ++pass)
      counts.measured += ShaderSearch::measuresAll(static_cast<int>(pass), kFreePasses)
                             ? counts.carved
                             : dueBetween(result.search, pass, result.depths.size);
  return counts;
}

int run() {
  const auto context = EglContext::create();
  if (!context) return 1;
  fmt::print("{:8} {:8} {:>8} {:>7} {:>11} {:>15} {:>7} {:>9}\n", "modules", "search", "carved", "passes", "read-backs",
             "texels computed", "sweeps", "mean, mm");
  struct Case {
    int version;
    double sizeMm, plateMm;
  };
  for (const Case& each : {Case{3, 24, 60}, Case{10, 58, 160}}) {
    auto prepared =
        prepareModel(shapes::soupOf(shapes::plate({each.plateMm, each.plateMm}, each.plateMm / 8, 8, 8)), {});
    if (!prepared) return 1;
    const auto model = EngravableModel::upload(std::move(*prepared));
    EngraveRequest request;
    request.code.text = "https://example.org/p/0123456789";
    request.code.symbol.version = each.version;
    request.depth.contrast = 0.3;  // a default contrast would change with the patterns
    request.placement.centreMm = Vec3(0, 0, each.plateMm / 16);
    request.placement.sizeMode = SizeMode::Fixed;
    request.placement.sizeMm = each.sizeMm;
    for (const bool onGpu : {false, true}) {
      const auto counts = count(model, request, onGpu);
      if (!counts) {
        fmt::print(stderr, "{}\n", sentenceAndHint(counts.error().message));
        return 1;
      }
      fmt::print("{:8} {:8} {:8} {:7} {:11} {:15} {:7} {:9.4f}\n", 17 + 4 * each.version, onGpu ? "batches" : "passes",
                 counts->carved, counts->passes, counts->readBacks, kTexelsPerCell * counts->measured, counts->sweeps,
                 counts->meanMm);
    }
  }
  return 0;
}

}  // namespace
}  // namespace qrelief

int main() { return qrelief::run(); }
