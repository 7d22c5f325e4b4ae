// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/read_model.h"

namespace qrelief {

/// 3MF, core specification and production extension: every item of the build, its components put together, transforms
/// applied (a mirrored instance is turned round, so that it still faces outwards); each item is a part of the soup, and
/// the file's unit is the soup's. Items that are no model (supports and the like), colours, textures and metadata are
/// passed over.
///
/// Hostile files end in an error soon and in bounded memory: what is unpacked, its ratio, the number of objects, how
/// deep components nest and what they multiply to are all limited before anything is made of them; no path leaves the
/// archive, and nothing but the parts asked for is unpacked.
/// @returns BadInput naming the part, the line and the object
Result<PolygonSoup> read3mf(std::span<const std::uint8_t> bytes, const ReadLimits& limits);

}  // namespace qrelief
