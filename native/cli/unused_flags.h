// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "base/message.h"
#include "cli/setting_flags.h"
#include "pipeline/placement.h"

namespace qrelief {

struct EngraveRequest;

/// Returns a warning for each given flag that has no effect on the request, such as --light on a painted code.
std::vector<Message> unusedFlags(const SettingFlags& flags, const EngraveRequest& request);

/// Returns a warning if the surface lies further from the given centre than a module.
std::optional<Message> centreMoved(Vec3 givenMm, const Placement& placement);

}  // namespace qrelief
