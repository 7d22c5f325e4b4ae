// SPDX-License-Identifier: GPL-3.0-or-later
#include "engine/guarded.h"

#include <exception>
#include <new>

#include "engine/answers.h"
#include "message_codes/engine.h"

namespace qrelief {

std::string guarded(const std::function<std::string()>& verb) {
  try {
    return verb();
  } catch (const std::bad_alloc&) {
    return answer(ErrorKind::Internal, message<"out-of-memory">());
  } catch (const std::exception& exception) {
    return answer(ErrorKind::Internal, message<"internal-fault">(with::term<"detail">(exception.what())));
  }
}

}  // namespace qrelief
