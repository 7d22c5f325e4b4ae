// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/zip_file.h"

#include <fmt/format.h>

namespace qrelief::zip_file {
namespace {

template <class T>
void put(std::string& bytes, T value) {
  for (std::size_t i = 0; i < sizeof(T); ++i)
    bytes += static_cast<char>(static_cast<std::uint64_t>(value) >> (8 * i) & 0xff);
}

/// Computes the checksum bit by bit, by its definition.
std::uint32_t crc32(const std::string& text) {
  std::uint32_t crc = 0xffffffff;
  for (const char c : text) {
    crc ^= static_cast<unsigned char>(c);
    for (int bit = 0; bit < 8; ++bit) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320u : 0u);
  }
  return ~crc;
}

void putCommon(std::string& bytes, const File& file) {
  const auto size = static_cast<std::uint32_t>(file.content.size());
  put<std::uint16_t>(bytes, 20);
  put(bytes, file.flags);
  put(bytes, file.method);
  put<std::uint32_t>(bytes, 0);
  put(bytes, file.crc.value_or(crc32(file.content)));
  put(bytes, file.packedSize.value_or(size));
  put(bytes, file.size.value_or(size));
}

std::string filesAndDirectory(const std::vector<File>& files, std::size_t& directory) {
  std::string bytes, lines;
  for (const File& file : files) {
    const auto at = static_cast<std::uint32_t>(bytes.size());
    const std::string& name = file.localName ? *file.localName : file.name;
    put<std::uint32_t>(bytes, 0x04034b50);
    putCommon(bytes, file);
    put(bytes, static_cast<std::uint16_t>(name.size()));
    put<std::uint16_t>(bytes, 0);
    bytes += name + file.content;

    put<std::uint32_t>(lines, 0x02014b50);
    put<std::uint16_t>(lines, 20);
    putCommon(lines, file);
    put(lines, static_cast<std::uint16_t>(file.name.size()));
    put(lines, static_cast<std::uint16_t>(file.extra.size()));
    put<std::uint16_t>(lines, 0);
    put<std::uint16_t>(lines, 0);
    put<std::uint16_t>(lines, 0);
    put<std::uint32_t>(lines, 0);
    put(lines, file.localHeader.value_or(at));
    lines += file.name + file.extra;
  }
  directory = bytes.size();
  return bytes + lines;
}

}  // namespace

std::vector<std::uint8_t> zip(const std::vector<File>& files) {
  std::size_t directory = 0;
  std::string bytes = filesAndDirectory(files, directory);
  const auto size = static_cast<std::uint32_t>(bytes.size() - directory);
  put<std::uint32_t>(bytes, 0x06054b50);
  put<std::uint32_t>(bytes, 0);
  put(bytes, static_cast<std::uint16_t>(files.size()));
  put(bytes, static_cast<std::uint16_t>(files.size()));
  put(bytes, size);
  put(bytes, static_cast<std::uint32_t>(directory));
  put<std::uint16_t>(bytes, 0);
  return {bytes.begin(), bytes.end()};
}

std::vector<std::uint8_t> zip64(const std::vector<File>& files) {
  std::size_t directory = 0;
  std::string bytes = filesAndDirectory(files, directory);
  const std::uint64_t size = bytes.size() - directory, end = bytes.size();
  put<std::uint32_t>(bytes, 0x06064b50);
  put<std::uint64_t>(bytes, 44);
  put<std::uint32_t>(bytes, 0x002d002d);
  put<std::uint64_t>(bytes, 0);
  put<std::uint64_t>(bytes, files.size());
  put<std::uint64_t>(bytes, files.size());
  put<std::uint64_t>(bytes, size);
  put<std::uint64_t>(bytes, directory);
  put<std::uint32_t>(bytes, 0x07064b50);
  put<std::uint32_t>(bytes, 0);
  put<std::uint64_t>(bytes, end);
  put<std::uint32_t>(bytes, 1);
  put<std::uint32_t>(bytes, 0x06054b50);
  put<std::uint32_t>(bytes, 0);
  put<std::uint32_t>(bytes, 0xffffffff);
  put<std::uint64_t>(bytes, 0xffffffffffffffff);
  put<std::uint16_t>(bytes, 0);
  return {bytes.begin(), bytes.end()};
}

std::vector<std::uint8_t> threeMf(const std::string& model, std::vector<File> more) {
  more.insert(more.begin(),
              {{"_rels/.rels",
                "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship "
                "Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
                "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>"},
               {"3D/3dmodel.model", model}});
  return zip(more);
}

std::string modelPart(const std::string& resources, const std::string& build, const std::string& attributes) {
  return fmt::format(
      "<?xml version=\"1.0\"?>\n<model xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" {}>\n"
      "<resources>\n{}</resources>\n<build>\n{}</build>\n</model>\n",
      attributes, resources, build);
}

std::string boxObject(int id, double x, double y, double z, const std::string& attributes) {
  std::string text = fmt::format("<object id=\"{}\" {}><mesh><vertices>\n", id, attributes);
  for (int i = 0; i < 8; ++i)
    text += fmt::format("<vertex x=\"{}\" y=\"{}\" z=\"{}\"/>\n", i & 1 ? x : 0, i & 2 ? y : 0, i & 4 ? z : 0);
  text += "</vertices><triangles>\n";
  constexpr int kTriangles[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                     {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  for (const auto& [a, b, c] : kTriangles) text += fmt::format("<triangle v1=\"{}\" v2=\"{}\" v3=\"{}\"/>\n", a, b, c);
  return text + "</triangles></mesh></object>\n";
}

}  // namespace qrelief::zip_file
