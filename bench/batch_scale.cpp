// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the cost of a large batch's plan and manifests, with a recorded result in place of carving:
//
//     qrelief_batch_scale FOLDER ROWS [SHARES]
//
// Makes a list of ROWS rows, plans them, appends a line for each as SHARES processes (1 by default) would, opens the
// folder as a process that resumes the first share, and merges. FOLDER must not exist yet; it is kept. Prints for each
// stage: wall-clock seconds, processor seconds, and peak memory so far.
#include <algorithm>
#include <charconv>
#include <ctime>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>

#include "base/clock.h"
#include "batch/batch_plan.h"
#include "batch/manifest.h"
#include "native/batch_folder.h"
#include "native/sha256.h"

namespace qrelief {
namespace {

/// Output of describeRow() for a row of public/samples/plate.stl.
constexpr const char* kRecorded =
    R"({"symbol":{"version":2,"errorCorrection":"M","mask":3,"symbolMm":21.0},"verdict":{"passed":true,)"
    R"("reads":"good","prints":"good","solid":"good"},"grades":{"iso15415":1.0,"iso29158":3.0},"depth":)"
    R"({"meanMm":0.4208,"maxMm":0.73,"p95Mm":0.6,"preset":"balanced"},"timingsMs":{"total":962.0}})";

/// Returns the peak memory since the last call, in MiB [proc(5)].
double peakMiB() {
  double peak = 0;
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("VmHWM:")) peak = std::stod(line.substr(6)) / 1024;
  std::ofstream("/proc/self/clear_refs") << 5;
  return peak;
}

class Stages {
 public:
  void end(const char* name) {
    fmt::print("| {} | {:.2f} | {:.2f} | {:.0f} |\n", name, millisecondsSince(start_) / 1000,
               static_cast<double>(std::clock() - processor_) / CLOCKS_PER_SEC, peakMiB());
    std::fflush(stdout);
    start_ = Clock::now();
    processor_ = std::clock();
  }

 private:
  Clock::time_point start_ = Clock::now();
  std::clock_t processor_ = std::clock();
};

std::string listOf(std::size_t rows) {
  std::string list = "id,text\n";
  for (std::size_t i = 1; i <= rows; ++i) list += fmt::format("P{0:08},https://example.org/p/{0:08}\n", i);
  return list;
}

ManifestEntry recorded(const BatchRow& row, const std::string& input) {
  ManifestEntry entry;
  entry.number = row.number;
  entry.id = row.id;
  entry.text = row.request.code.text;
  entry.file = row.file;
  entry.sha256 = {input, sha256(settingsToHash(row, {})), sha256(row.request.code.text), {}};
  entry.status = RowStatus::Done;
  entry.details = kRecorded;
  return entry;
}

Status measure(const std::string& path, std::size_t rows, std::size_t shares) {
  fmt::print("{} rows, {} shares\n\n| stage | s | processor, s | peak MiB |\n|---|---:|---:|---:|\n", rows, shares);
  peakMiB();
  Stages stages;
  const std::string text = listOf(rows);
  auto list = readBatchList({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
  QRELIEF_TRY(list);
  stages.end("list");
  const BatchPlan plan = BatchPlan::make(std::move(*list), {});
  if (!plan.problems().empty()) return badInput(plan.problems().front());
  stages.end("plan");
  const std::string input = sha256(path);
  for (std::size_t index = 0; index < shares; ++index) {
    auto folder = BatchFolder::open(path, {index, shares});
    QRELIEF_TRY(folder);
    for (std::size_t i = index; i < rows; i += shares) QRELIEF_TRY(folder->append(recorded(plan.row(i), input)));
  }
  stages.end("append");
  QRELIEF_TRY(BatchFolder::open(path, {0, shares}));
  stages.end("open again");
  const auto folder = BatchFolder::open(path, {});
  QRELIEF_TRY(folder);
  stages.end("merge: open");
  std::size_t visited = 0;
  const Status read = folder->forEach([&](const ManifestEntry&) -> Status { return ++visited, Status(); });
  if (!read) return read;
  stages.end("merge: visit");
  const std::size_t doubles = folder->doubles().size();
  stages.end("merge: doubles");
  const Status written = folder->writeManifest(rows);
  stages.end("merge: write");
  fmt::print("\n{} rows merged, {} double, {:.1f} MiB\n", visited, doubles,
             static_cast<double>(std::filesystem::file_size(path + "/manifest.jsonl")) / (1 << 20));
  return written;
}

}  // namespace
}  // namespace qrelief

int main(int argc, char** argv) {
  const auto number = [&](int at, std::size_t otherwise) {
    std::size_t value = otherwise;
    if (at < argc) std::from_chars(argv[at], argv[at] + std::string_view(argv[at]).size(), value);
    return value;
  };
  const std::size_t rows = number(2, 0), shares = number(3, 1);
  if (rows == 0 || shares == 0 || std::filesystem::exists(argv[1])) {
    fmt::print(stderr, "qrelief_batch_scale NEW_FOLDER ROWS [SHARES]\n");
    return 2;
  }
  if (const auto measured = qrelief::measure(argv[1], rows, shares); !measured) {
    fmt::print(stderr, "qrelief_batch_scale: {}\n", measured.error().message.code);
    return 1;
  }
  return 0;
}
