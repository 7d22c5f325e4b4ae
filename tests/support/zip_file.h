// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// ZIP archives with any defect a test needs; nothing is compressed.
namespace qrelief::zip_file {

struct File {
  std::string name, content;
  std::uint16_t flags = 0, method = 0;
  std::optional<std::uint32_t> crc = {}, size = {}, packedSize = {}, localHeader = {};  ///< empty: the true value
  std::optional<std::string> localName = {};  ///< name in the file's own header
  std::string extra = {};                     ///< extra field in the directory
};

std::vector<std::uint8_t> zip(const std::vector<File>& files);

/// Writes the same with ZIP64 end records; all the numbers of the plain end record refer to them.
std::vector<std::uint8_t> zip64(const std::vector<File>& files);

/// Builds a 3MF file: the relationship, and 3D/3dmodel.model with the given text.
std::vector<std::uint8_t> threeMf(const std::string& model, std::vector<File> more = {});

/// Returns the text of a model part.
/// @param attributes  further attributes of <model>
std::string modelPart(const std::string& resources, const std::string& build, const std::string& attributes = {});

/// Returns an <object> with a box of the given size from the origin, 8 vertices, 12 triangles.
std::string boxObject(int id, double x, double y, double z, const std::string& attributes = {});

}  // namespace qrelief::zip_file
