// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/unused_flags.h"

#include <array>
#include <glm/glm.hpp>

#include "message_codes/command.h"
#include "settings/engrave_request.h"

namespace qrelief {
namespace {

// Settings that MarkRequest::mark says have no effect on a mark.
constexpr std::array kOfShadows = {"preset",   "keepPreset", "pattern", "patternMask", "finderPattern", "contrast",
                                   "carveFor", "objective",  "solver",  "maxDepthMm",  "light",         "surface"};
constexpr std::array kOfCodes = {"ecc", "version", "mask", "eci", "quietZone"};
constexpr std::array kOfColours = {"markDepthMm", "darkReflectance"};

}  // namespace

std::vector<Message> unusedFlags(const SettingFlags& flags, const EngraveRequest& request) {
  std::vector<Message> unused;
  const MarkRequest& marking = request.marking;
  if (request.code.isText()) {
    for (const char* key : kOfCodes)
      if (flags.isGiven(key)) unused.push_back(message<"text-ignores-it">(with::setting<"option">(key)));
    for (const char* key : kOfShadows)
      if (flags.isGiven(key)) unused.push_back(message<"text-ignores-it">(with::setting<"option">(key)));
    if (!marking.isInColour() && !marking.isOpen && flags.isGiven("albedo"))
      unused.push_back(message<"text-ignores-it">(with::setting<"option">("albedo")));
  } else if (marking.isInColour()) {
    for (const char* key : kOfShadows)
      if (flags.isGiven(key))
        unused.push_back(
            message<"mark-ignores-it">(with::setting<"option">(key), with::term<"mark">(markName(marking.mark))));
    if (marking.mark == Mark::Paint && flags.isGiven("markDepthMm"))
      unused.push_back(message<"mark-ignores-it">(with::setting<"option">("markDepthMm"),
                                                  with::term<"mark">(markName(marking.mark))));
  } else if (!marking.isOpen) {
    for (const char* key : kOfColours)
      if (flags.isGiven(key)) unused.push_back(message<"mark-needs-colour">(with::setting<"option">(key)));
  }
  if (request.placement.sizeMode == SizeMode::Fixed && flags.isGiven("maxSizeMm"))
    unused.push_back(message<"size-is-fixed">(with::setting<"option">("maxSizeMm")));
  return unused;
}

std::optional<Message> centreMoved(Vec3 givenMm, const Placement& placement) {
  const double distance = glm::distance(givenMm, placement.frame.centre);
  if (distance <= placement.moduleMm) return std::nullopt;
  return message<"centre-moved">(with::lengthMm<"distance">(distance));
}

}  // namespace qrelief
