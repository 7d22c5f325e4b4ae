// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

namespace qrelief {

/// A verb's answer, or the exception that ended it as one: {"ok": false, "error": …} with the code OutOfMemory or
/// Internal.
std::string guarded(const std::function<std::string()>& verb);

}  // namespace qrelief
