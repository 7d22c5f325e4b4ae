// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// ZIP archives as bad as a test wants them; nothing is compressed.
namespace qrelief::zip_file {

struct File {
  std::string name, content;
  std::uint16_t flags = 0, method = 0;
  std::optional<std::uint32_t> crc = {}, size = {}, packedSize = {}, localHeader = {};  ///< empty: the truth
  std::optional<std::string> localName = {};                                            ///< in the file's own header
  std::string extra = {};  ///< extra field of the directory
};

std::vector<std::uint8_t> zip(const std::vector<File>& files);

/// The same with ZIP64 end records, and all the plain one's numbers saying so.
std::vector<std::uint8_t> zip64(const std::vector<File>& files);

/// A 3MF file: relationship, and 3D/3dmodel.model with the given text.
std::vector<std::uint8_t> threeMf(const std::string& model, std::vector<File> more = {});

/// The text of a model part.
/// @param attributes  more of them for <model>
std::string modelPart(const std::string& resources, const std::string& build, const std::string& attributes = {});

/// <object> with a box of that size from the origin, 8 vertices, 12 triangles.
std::string boxObject(int id, double x, double y, double z, const std::string& attributes = {});

}  // namespace qrelief::zip_file
