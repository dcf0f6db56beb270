// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/message.h"

#include <Eigen/Core>

#include <expected>
#include <string>
#include <utility>
#include <vector>

namespace moldwright {

/// Why something expected did not succeed. The command line maps it to an exit code.
enum class ErrorCode {
    Usage,       ///< the request makes no sense (exit 2)
    BadInput,    ///< a file or mesh cannot be used (exit 3)
    Impossible,  ///< a named obstruction stands in the way of these choices (exit 4)
    Cancelled,   ///< stopped by the user or by the time limit (exit 5)
    WriteFailed, ///< a file could not be written (exit 3)
    Worker,      ///< the worker program failed, was killed, or answered nonsense (exit 70)
    Internal     ///< a promise inside the program broke (exit 70)
};

/// An expected failure as a value: what happened, and where, so that a view can point at it.
struct Error {
    ErrorCode code = ErrorCode::Internal;
    Message message;
    std::vector<int> faces;                ///< faces of the mesh concerned; may be empty
    std::vector<Eigen::Vector3d> places{}; ///< points concerned, mm, in the input's frame; may be empty

    [[nodiscard]] std::string english() const { return message.english(); }
};

template <class T>
using Result = std::expected<T, Error>;

/// A failure ready to return from a function that yields Result.
[[nodiscard]] inline std::unexpected<Error> failure(ErrorCode code, std::string text,
                                                    std::vector<std::string> arguments = {}) {
    return std::unexpected(Error{code, {std::move(text), std::move(arguments)}, {}, {}});
}

} // namespace moldwright
