// SPDX-License-Identifier: GPL-3.0-or-later
// How deep against how well read: uniform depth, the paper's search and rule, the same rule by the fast search, and the
// objective `reading`, at several settings each, on a plate and three curved shapes.
//
//     qrelief_frontier [SHAPE…]           plate, ball, bumps, saddle; all of them
//
// Depth: mean over the carved submodules, mm. Read: share of the tries on simulated pictures from the front that give
// the text (verification/reading_sweep.h: ZXing-C++ with two binarisers). Version 3, symbols 35 mm wide.
#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <string>
#include <vector>

#include "messages/sentences.h"
#include "native/egl_context.h"
#include "native/zxing_reader.h"
#include "pipeline/engrave.h"
#include "pipeline/verify.h"
#include "support/shapes.h"

namespace qrelief {
namespace {

struct Shape {
  const char* name;
  Mesh mesh;
  Vec3 centre;
};

struct Method {
  const char* name;
  std::vector<double> levels;  // of what `set` sets
  std::function<void(EngraveRequest&, double)> set;
};

std::vector<Shape> shapesAskedFor(const std::vector<std::string>& names) {
  std::vector<Shape> all;
  all.push_back({"plate", shapes::plate({60, 60}, 10, 4, 4), {0, 0, 0}});
  all.push_back({"ball", shapes::icosphere(40, 5), {0, 0, 40}});
  all.push_back({"bumps", shapes::bumpySphere(45, 0.6, 6, 6), {0, 0, 45}});
  all.push_back({"saddle",
                 shapes::plate({70, 70}, 20, 80, 80, [](double x, double y) { return (x * x - y * y) / 120; }),
                 {0, 0, 0}});
  if (names.empty()) return all;
  std::erase_if(all,
                [&](const Shape& shape) { return std::find(names.begin(), names.end(), shape.name) == names.end(); });
  return all;
}

std::vector<Method> methods() {
  const auto byContrast = [](ContrastSolver solver) {
    return [solver](EngraveRequest& request, double contrast) {
      request.solver = solver;
      request.contrast = contrast;
    };
  };
  return {{"uniform depth (mm)",
           {0.1, 0.2, 0.3, 0.4, 0.6},
           [](EngraveRequest& request, double depthMm) {
             request.maxDepthMm = depthMm;
             request.contrast = 0.95;  // never reached: everything goes to the limit
           }},
          {"paper steps (contrast)", {0.05, 0.1, 0.15, 0.2, 0.3}, byContrast(ContrastSolver::PaperSteps)},
          {"fast (contrast)", {0.05, 0.1, 0.15, 0.2, 0.3}, byContrast(ContrastSolver::Fast)},
          {"reading (data contrast)", {0.03, 0.05, 0.08, 0.12, 0.2}, [](EngraveRequest& request, double contrast) {
             request.objective = DepthObjective::Reading;
             request.reading.dataContrast = contrast;
             request.reading.finderContrast = 1.5 * contrast;
           }}};
}

Result<double> shareThatReads(const EngraveResult& engraved, const EngraveRequest& request) {
  VerifyRequest checked;
  checked.frame = engraved.placement.frame;
  checked.symbolMm = engraved.placement.symbolMm;
  checked.text = request.text;
  checked.symbol = engraved.symbol;
  checked.ranges = false;
  auto job = VerifyJob::create(engraved.mesh, checked, zxingReaders());
  if (!job) return tl::unexpected(job.error());
  const auto result = runToEnd(**job);
  if (!result) return tl::unexpected(result.error());
  const ReadingCount& count = result->reading.frontal;
  return static_cast<double>(count.reads) / count.tries;
}

Status printRows(const Shape& shape) {
  auto prepared = prepareModel(shapes::soupOf(shape.mesh), {});
  if (!prepared) return tl::unexpected(prepared.error());
  const auto model = EngravableModel::upload(std::move(*prepared));
  for (const Method& method : methods()) {
    for (const double level : method.levels) {
      EngraveRequest request;
      request.text = "https://example.com/qrelief";
      request.symbol.version = 3;
      request.placement.centreMm = shape.centre;
      request.placement.upHint = {0, 1, 0};
      request.placement.sizeMode = SizeMode::Fixed;
      request.placement.sizeMm = 35;
      method.set(request, level);
      const auto engraved = engrave(model, request);
      if (!engraved) return tl::unexpected(engraved.error());
      const auto share = shareThatReads(*engraved, request);
      if (!share) return tl::unexpected(share.error());
      fmt::print("| {} | {} | {:g} | {:.3f} | {:.2f} |\n", shape.name, method.name, level,
                 summarise(engraved->depths).meanMm, *share);
      std::fflush(stdout);
    }
  }
  return {};
}

int failed(const std::string& what, const Error& error) {
  fmt::print(stderr, "{}: {}\n", what, sentenceAndHint(error.message));
  return 1;
}

int run(const std::vector<std::string>& names) {
  const std::vector<Shape> chosen = shapesAskedFor(names);
  if (chosen.empty() || chosen.size() < names.size()) {
    fmt::print(stderr, "shapes are plate, ball, bumps, saddle\n");
    return 2;
  }
  const auto context = EglContext::create();
  if (!context) return failed("EGL", context.error());
  fmt::print("| shape | method | at | mean depth (mm) | read |\n|---|---|---|---|---|\n");
  for (const Shape& shape : chosen)
    if (const Status printed = printRows(shape); !printed) return failed(shape.name, printed.error());
  return 0;
}

}  // namespace
}  // namespace qrelief

int main(int argc, char** argv) { return qrelief::run({argv + 1, argv + argc}); }
