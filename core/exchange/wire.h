// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"

#include <Eigen/Core>

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace moldwright {

/// Packs values into bytes for the worker program or back from it. Both ends run on one machine, so numbers
/// keep its byte order.
class WireWriter {
public:
    void number(std::int64_t value) { append(&value, sizeof value); }
    void text(std::string_view value);
    void message(const Message& value);
    void error(const Error& value);

    /// A row-major matrix: its rows, then its coefficients.
    template <class Matrix>
    void matrix(const Matrix& M) {
        number(M.rows());
        append(M.data(), static_cast<std::size_t>(M.size()) * sizeof(typename Matrix::Scalar));
    }

    [[nodiscard]] const std::string& bytes() const { return m_bytes; }

private:
    void append(const void* data, std::size_t size) { m_bytes.append(static_cast<const char*>(data), size); }
    std::string m_bytes;
};

/// Unpacks what WireWriter packed, in the same order. Bytes that end too early or announce more than they
/// hold never allocate for it: they yield empty values and whole() turns false for good.
class WireReader {
public:
    explicit WireReader(std::string_view bytes) : m_rest(bytes) {}

    [[nodiscard]] std::int64_t number();
    [[nodiscard]] std::string text();
    [[nodiscard]] Message message();
    [[nodiscard]] Error error();

    template <class Matrix>
    [[nodiscard]] Matrix matrix() {
        const std::size_t rowBytes = Matrix::ColsAtCompileTime * sizeof(typename Matrix::Scalar);
        const std::size_t rows = count(rowBytes);
        Matrix M(static_cast<Eigen::Index>(rows), Matrix::ColsAtCompileTime);
        const std::string_view data = take(rows * rowBytes);
        if (!data.empty())
            std::memcpy(M.data(), data.data(), data.size());
        return M;
    }

    /// True as long as everything asked for was there.
    [[nodiscard]] bool whole() const { return m_whole; }

private:
    /// A count of items of `itemBytes` each that fits into what is left; 0 otherwise.
    std::size_t count(std::size_t itemBytes);
    std::string_view take(std::size_t size);

    std::string_view m_rest;
    bool m_whole = true;
};

} // namespace moldwright
