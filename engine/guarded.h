// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

namespace qrelief {

/// A verb's answer, or the exception that ended it as one, with the code out-of-memory or internal-fault.
std::string guarded(const std::function<std::string()>& verb);

}  // namespace qrelief
