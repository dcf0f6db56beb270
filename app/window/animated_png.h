// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QImage>

#include <cstdint>

namespace moldwright {

/// Pictures of one size, one after the other, as the bytes of an animated PNG that runs for ever: viewers
/// without animation show the first one. [APNG specification 1.0]
class AnimatedPng {
public:
    explicit AnimatedPng(int millisecondsEach) : m_milliseconds(millisecondsEach) {}

    /// Precondition: of the size of those before.
    void add(const QImage& picture);
    [[nodiscard]] int count() const { return m_count; }

    /// The whole file; empty without pictures.
    [[nodiscard]] QByteArray bytes() const;

private:
    int m_milliseconds;
    int m_count = 0;
    std::uint32_t m_sequence = 0; ///< number of the next control or data chunk
    QByteArray m_header;          ///< the chunk IHDR
    QByteArray m_frames;          ///< all chunks of the pictures
};

} // namespace moldwright
