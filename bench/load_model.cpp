// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the time from a model's bytes to a welded, checked, searchable mesh, and assimp's time to read and weld it,
// if assimp is installed. Prints the median of some runs, one line each: "NAME MILLISECONDS TRIANGLES". Run by
// bench/load_peers.mjs, which compares it with three.js.
//
//     qrelief_load_bench MODEL [SCALE] [RUNS]
#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <iterator>

#include "base/clock.h"
#include "io/read_model.h"
#include "mesh/prepare.h"
#include "messages/sentences.h"

#ifdef QRELIEF_ASSIMP
#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#endif

namespace qrelief {
namespace {

double median(std::vector<double> times) {
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

int measure(const std::string& path, double scale, int runs) {
  std::ifstream stream(path, std::ios::binary);
  const std::vector<std::uint8_t> bytes(std::istreambuf_iterator<char>(stream), {});
  std::vector<double> reading, preparing, both;
  std::size_t triangles = 0;
  for (int run = 0; run < runs; ++run) {
    const auto start = Clock::now();
    const auto soup = readModel(bytes, path);
    reading.push_back(millisecondsSince(start));
    const auto read = Clock::now();
    const auto model = soup ? prepareModel(*soup, {.scaleToMm = scale}) : tl::unexpected(soup.error());
    preparing.push_back(millisecondsSince(read));
    both.push_back(millisecondsSince(start));
    if (!model) {
      fmt::print(stderr, "qrelief_load_bench: {}\n", sentenceAndHint(model.error().message));
      return 1;
    }
    triangles = model->mesh.triangles.size();
  }
  fmt::print("qrelief-read {:.1f} {}\nqrelief-prepare {:.1f} {}\nqrelief {:.1f} {}\n", median(reading), triangles,
             median(preparing), triangles, median(both), triangles);
#ifdef QRELIEF_ASSIMP
  const std::string extension = path.substr(path.rfind('.') + 1);
  std::vector<double> peer;
  for (int run = 0; run < runs; ++run) {
    const auto start = Clock::now();
    Assimp::Importer importer;
    const aiScene* scene = importer.ReadFileFromMemory(
        bytes.data(), bytes.size(), aiProcess_Triangulate | aiProcess_JoinIdenticalVertices, extension.c_str());
    peer.push_back(millisecondsSince(start));
    triangles = scene && scene->mNumMeshes > 0 ? scene->mMeshes[0]->mNumFaces : 0;
  }
  fmt::print("assimp {:.1f} {}\n", median(peer), triangles);
#endif
  return 0;
}

}  // namespace
}  // namespace qrelief

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "usage: qrelief_load_bench MODEL [SCALE] [RUNS]\n");
    return 2;
  }
  return qrelief::measure(argv[1], argc > 2 ? std::atof(argv[2]) : 1, argc > 3 ? std::max(1, std::atoi(argv[3])) : 5);
}
