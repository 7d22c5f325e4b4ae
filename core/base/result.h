// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace qrelief {

/// Why something could not be done; the command's exit status follows from it.
enum class ErrorCode {
  BadUsage,    ///< the request itself makes no sense (exit status 2)
  BadInput,    ///< the file or the text cannot be used (3)
  NoSolution,  ///< good input, but nothing fits it (4)
  Internal,    ///< a fault of ours (5)
};

/// What was found, and what would help: both are shown to the user as they are.
struct Error {
  ErrorCode code = ErrorCode::Internal;
  std::string message;  ///< what was found and where (line, facet, byte); a sentence without full stop
  std::string hint;     ///< what would help; may be empty
};

template <class T>
using Result = tl::expected<T, Error>;
using Status = Result<void>;

/// `return fail(ErrorCode::BadInput, "...", "...");` from any function returning Result.
inline tl::unexpected<Error> fail(ErrorCode code, std::string message, std::string hint = {}) {
  return tl::unexpected<Error>(Error{code, std::move(message), std::move(hint)});
}

}  // namespace qrelief
