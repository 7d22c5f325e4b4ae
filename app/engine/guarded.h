// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

namespace qrelief {

/// Returns a verb's answer. If an exception ends the verb, returns an error with the code out-of-memory or
/// internal-fault.
std::string guarded(const std::function<std::string()>& verb);

}  // namespace qrelief
