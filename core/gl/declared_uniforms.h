// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace qrelief::gl {

/// Names of the uniforms that a shader declares, whether or not they are used; an array without its brackets. Uniform
/// blocks and what the preprocessor leaves out are not told apart, as no shader has either.
///
/// Cost: linear in the text.
/// @param source  GLSL ES 3.00, its includes resolved
std::vector<std::string> declaredUniforms(std::string_view source);

}  // namespace qrelief::gl
