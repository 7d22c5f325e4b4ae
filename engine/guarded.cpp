// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/guarded.h"

#include <exception>
#include <new>

#include "engine/answers.h"

namespace qrelief {
namespace {

std::string failure(const char* code, const char* what, const char* hint) {
  return textOf({{"ok", false}, {"error", {{"code", code}, {"message", what}, {"hint", hint}}}});
}

}  // namespace

std::string guarded(const std::function<std::string()>& verb) {
  try {
    return verb();
  } catch (const std::bad_alloc&) {
    return failure("OutOfMemory", "there is not enough memory for this",
                   "use a model with fewer triangles, or close other tabs");
  } catch (const std::exception& exception) {
    return failure("Internal", exception.what(),
                   "this is a fault of QRelief: please report it with the model and the settings");
  }
}

}  // namespace qrelief
