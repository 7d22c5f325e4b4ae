// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

#include "base/message.h"

namespace qrelief {

/// Why something could not be done; the command's exit status follows from it.
enum class ErrorKind {
  BadUsage,    ///< the request itself makes no sense (exit status 2)
  BadInput,    ///< the file or the text cannot be used (3)
  NoSolution,  ///< good input, but nothing fits it (4)
  Internal,    ///< a fault of ours (5)
};

/// What was found; the sentence, and what would help, follow from the message's code (messages/).
struct Error {
  ErrorKind kind = ErrorKind::Internal;
  Message message;
};

template <class T>
using Result = tl::expected<T, Error>;
using Status = Result<void>;

/// `return badInput(message("stl-empty"));` from any function returning Result.
inline tl::unexpected<Error> fail(ErrorKind kind, Message message) {
  return tl::unexpected<Error>(Error{kind, std::move(message)});
}
inline tl::unexpected<Error> badInput(Message message) { return fail(ErrorKind::BadInput, std::move(message)); }

}  // namespace qrelief
