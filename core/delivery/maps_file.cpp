// SPDX-License-Identifier: GPL-3.0-or-later
#include "delivery/maps_file.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "io/zip_writer.h"

namespace qrelief {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// Adds an array of at least two dimensions in format version 1.0, whose header is padded to a multiple of 64 bytes
/// [NEP 1].
void addArray(ZipWriter& zip, std::string_view name, std::initializer_list<std::size_t> shape,
              std::span<const float> values) {
  static_assert(std::endian::native == std::endian::little);
  constexpr std::size_t kPreamble = 10, kAlignment = 64;
  std::string header =
      fmt::format("{{'descr': '<f4', 'fortran_order': False, 'shape': ({}), }}", fmt::join(shape, ", "));
  header.append(kAlignment - 1 - (kPreamble + header.size()) % kAlignment, ' ');
  header += '\n';
  std::string preamble = "\x93NUMPY\x01";
  preamble += '\0';
  preamble += static_cast<char>(header.size() & 0xff);
  preamble += static_cast<char>(header.size() >> 8);
  zip.begin(fmt::format("{}.npy", name));
  zip.append(preamble);
  zip.append(header);
  const auto bytes = std::as_bytes(values);
  zip.append({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

void addSurface(ZipWriter& zip, const EngravableModel& model, const EngraveResult& result) {
  const int texels = result.readerView.luminance.rows();
  const auto n = static_cast<std::size_t>(texels);
  const std::vector<float> drawn =
      model.raster->draw(result.placement.frame, {result.readerOptions.extentMm, texels});  // row 0 at the bottom
  std::vector<float> normals, heights, luminance;
  for (std::size_t row = n; row-- > 0;)
    for (std::size_t column = 0; column < n; ++column) {
      const float* texel = &drawn[4 * (row * n + column)];
      const bool isSurface = texel[0] != 0 || texel[1] != 0 || texel[2] != 0;
      for (std::size_t k = 0; k < 3; ++k) normals.push_back(isSurface ? texel[k] : kNaN);
      heights.push_back(isSurface ? texel[3] : kNaN);
      luminance.push_back(result.readerView.luminance[row * n + column]);
    }
  addArray(zip, "normal", {n, n, 3}, normals);
  addArray(zip, "height", {n, n}, heights);
  addArray(zip, "luminance", {n, n}, luminance);
}

void addPasses(ZipWriter& zip, const EngraveResult& result) {
  const SearchRecord& search = result.search;
  const std::size_t edge = static_cast<std::size_t>(result.depths.size), cells = edge * edge;
  const auto values = [&](std::vector<float> SearchRecord::Pass::*ofPass) {
    std::vector<float> all(search.passes.size() * cells, kNaN);
    for (std::size_t pass = 0; pass < search.passes.size(); ++pass)
      for (std::size_t k = 0; k < search.carved.size(); ++k)
        all[pass * cells + search.carved[k]] = (search.passes[pass].*ofPass)[k];
    return all;
  };
  addArray(zip, "pass_depth", {search.passes.size(), edge, edge}, values(&SearchRecord::Pass::depthMm));
  addArray(zip, "pass_luminance", {search.passes.size(), edge, edge}, values(&SearchRecord::Pass::luminance));
}

}  // namespace

Result<std::vector<std::uint8_t>> encodeMaps(const EngravableModel& model, const EngraveResult& result) {
  ZipWriter zip;
  addSurface(zip, model, result);
  const std::vector<float> depths(result.depths.depthMm.begin(), result.depths.depthMm.end());
  const auto edge = static_cast<std::size_t>(result.depths.size);
  addArray(zip, "depth", {edge, edge}, depths);
  addPasses(zip, result);
  return zip.finish();
}

}  // namespace qrelief
