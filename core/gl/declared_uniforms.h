// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace qrelief::gl {

/// Returns the names of all uniforms that a shader declares, used or not; an array's name without its brackets. Does
/// not handle uniform blocks or preprocessor conditions, as no shader has either.
///
/// Cost: linear in the text.
/// @param source  GLSL ES 3.00, its includes resolved
std::vector<std::string> declaredUniforms(std::string_view source);

}  // namespace qrelief::gl
