// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

#include "base/message.h"

namespace qrelief {

/// Kind of an error; it decides the command's exit status.
enum class ErrorKind {
  BadUsage,    ///< the request itself makes no sense (exit status 2)
  BadInput,    ///< the file or the text cannot be used (3)
  NoSolution,  ///< good input, but nothing fits it (4)
  Internal,    ///< a bug in QRelief (5)
};

/// An error. Its sentence and its hint follow from the message's code (messages/).
struct Error {
  ErrorKind kind = ErrorKind::Internal;
  Message message;
};

template <class T>
using Result = tl::expected<T, Error>;
using Status = Result<void>;

/// Makes an error to return from any function that returns a Result: `return badInput(message<"stl-empty">());`.
inline tl::unexpected<Error> fail(ErrorKind kind, Message message) {
  return tl::unexpected<Error>(Error{kind, std::move(message)});
}
inline tl::unexpected<Error> badInput(Message message) { return fail(ErrorKind::BadInput, std::move(message)); }

}  // namespace qrelief

/// Returns the error of a Result or Status from the function, if it has one. The value stays in the Result:
///
///     auto mesh = readMesh(bytes);
///     QRELIEF_TRY(mesh);
///     QRELIEF_TRY(check(*mesh));
#define QRELIEF_TRY(result)                                                            \
  do {                                                                                 \
    if (auto&& triedResult = (result); !triedResult)                                   \
      return tl::unexpected(std::forward<decltype(triedResult)>(triedResult).error()); \
  } while (false)
