// SPDX-License-Identifier: GPL-3.0-or-later
// Engraves made-up models with made-up requests and judges every outcome (tests/support/engrave_oracle.h).
//
//     qrelief_property_bench [CASES] [SEED]           2000 cases with the seeds SEED, SEED + 1, ...; SEED is 1
//     qrelief_property_bench CASES SEED carving       the same without rendering: depths are made up, too
//
// A case with a wrong outcome is printed with the command that repeats it, and makes the program fail.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <fmt/format.h>
#include <map>

#include "messages/sentences.h"
#include "native/egl_context.h"
#include "support/engrave_oracle.h"

namespace qrelief {
namespace {

int run(std::uint64_t cases, std::uint64_t first, bool carvingOnly) {
  std::unique_ptr<EglContext> context;
  if (!carvingOnly) {
    auto created = EglContext::create();
    if (!created) {
      fmt::print(stderr, "qrelief_property_bench: {}\n", sentence(created.error().message));
      return 2;
    }
    context = std::move(*created);
  }
  const auto start = std::chrono::steady_clock::now();
  std::map<std::string, std::map<std::string, int>> shapesByKind;
  std::uint64_t faults = 0;
  for (std::uint64_t seed = first; seed < first + cases; ++seed) {
    Choices choices(seed);
    const EngraveCase engraveCase = makeEngraveCase(choices);
    const OracleVerdict verdict = carvingOnly ? runCarvingCase(engraveCase, choices) : runEngraveCase(engraveCase);
    ++shapesByKind[verdict.kind][engraveCase.shape];
    if (verdict.fault.empty() && cases > 1) continue;
    faults += verdict.fault.empty() ? 0 : 1;
    fmt::print("qrelief_property_bench 1 {}{}: {}: {}: {}\n", seed, carvingOnly ? " carving" : "",
               engraveCase.describe(), verdict.kind, verdict.fault);
    std::fflush(stdout);
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  for (const auto& [kind, shapes] : shapesByKind) {
    int total = 0;
    std::string detail;
    for (const auto& [shape, count] : shapes) {
      total += count;
      detail += fmt::format("{}{} {}", detail.empty() ? "" : ", ", count, shape);
    }
    fmt::print("{:>6}  {}: {}\n", total, kind, detail);
  }
  fmt::print("{} cases from seed {}, {} faults, {:.0f} s\n", cases, first, faults, seconds.count());
  return faults == 0 ? 0 : 1;
}

}  // namespace
}  // namespace qrelief

int main(int argc, char** argv) {
  const std::uint64_t cases = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 2000;
  const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  return qrelief::run(cases, seed, argc > 3 && std::string_view(argv[3]) == "carving");
}
