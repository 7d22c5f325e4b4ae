// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <string>

namespace qrelief::study {

/// A part of the program that table rows depend on, with the version of its results. Raise the version when you change
/// its results by more than rounding: `script/study` then measures the dependent rows again.
struct Part {
  const char* name;
  int version;
};

inline constexpr Part kPlacement{"placement", 1};  ///< directions and sizes: core/projection
inline constexpr Part kSearch{"search", 2};        ///< depths by the program itself: core/depth, core/pipeline
inline constexpr Part kHbao{"hbao", 1};            ///< light by horizon-based ambient occlusion: study/hbao_light.h
inline constexpr Part kLiteral{"papp-2022-literal", 1};  ///< depths by study/methods/literal_2022.h
inline constexpr Part kLight{"light", 2};        ///< light on carved surfaces, 1: by path tracing (decision 0040)
inline constexpr Part kLamps{"lamps", 1};        ///< light of lamps: core/light, shaders/hbao.frag
inline constexpr Part kPrint{"print", 2};        ///< the surface as printed: core/printing
inline constexpr Part kDecoding{"decoding", 1};  ///< pictures and decoders: core/verification

/// Returns the versions as tables have them: "search 2 light 2".
inline std::string versionOf(std::initializer_list<Part> parts) {
  std::string version;
  for (const Part& part : parts)
    version += (version.empty() ? "" : " ") + std::string(part.name) + " " + std::to_string(part.version);
  return version;
}

}  // namespace qrelief::study
