// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/three_mf/model.h"

namespace qrelief {

/// Consecutive triangles of a soup that come from one volume of a 3MF file.
struct ThreeMfRun {
  std::size_t firstTriangle = 0, count = 0;  ///< in the soup
  std::size_t firstInMesh = 0;               ///< index of the first triangle in its mesh
  std::size_t item = 0;                      ///< index of the build item
  std::uint32_t itemObject = 0;              ///< the item's object, in the start part
  std::string part;                          ///< the model part that holds the mesh
  std::uint32_t object = 0;                  ///< the object with the mesh
  std::string name;                          ///< of that object, UTF-8; may be empty
  Affine toFile;                             ///< from the mesh's coordinates to file units
  bool mirrored = false;                     ///< the soup's triangles are reversed
};

/// A 3MF file whose models were read; kept because rewriting needs everything else in it (rewrite_3mf.h).
struct ThreeMfSource {
  std::vector<std::uint8_t> bytes;  ///< the whole file
  std::string start;                ///< name of the start part
  double unitMm = 1;                ///< of the start part
  std::vector<ThreeMfRun> runs;     ///< ascending, without gaps
  bool isPainted = false;           ///< some facets of the runs are painted
  std::size_t plates = 0;           ///< ThreeMfVolumes::plates
};

}  // namespace qrelief
