// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/animated_png.h"

#include <QBuffer>
#include <QtEndian>

namespace moldwright {

namespace {

const QByteArray signature("\x89PNG\r\n\x1a\n", 8);

template <class Number>
QByteArray bigEndian(Number number) {
    QByteArray bytes(sizeof(Number), '\0');
    qToBigEndian(number, bytes.data());
    return bytes;
}

/// The checksum that ends each chunk: CRC-32 over its name and data.
std::uint32_t checksum(const QByteArray& bytes) {
    std::uint32_t crc = 0xffffffffU;
    for (const char byte : bytes) {
        crc ^= static_cast<std::uint8_t>(byte);
        for (int bit = 0; bit < 8; ++bit)
            crc = (crc >> 1) ^ (crc & 1 ? 0xedb88320U : 0U);
    }
    return ~crc;
}

QByteArray chunk(const char* name, const QByteArray& data) {
    const QByteArray named = QByteArray(name, 4) + data;
    return bigEndian(static_cast<std::uint32_t>(data.size())) + named + bigEndian(checksum(named));
}

QByteArray pngOf(const QImage& picture) {
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    picture.convertToFormat(QImage::Format_RGB888).save(&buffer, "PNG");
    return png;
}

/// Calls `use` with the name and the data of each chunk of a PNG.
template <class Use>
void eachChunk(const QByteArray& png, Use use) {
    for (qsizetype at = signature.size(); at + 12 <= png.size();) {
        const auto length = static_cast<qsizetype>(qFromBigEndian<std::uint32_t>(png.constData() + at));
        use(png.mid(at + 4, 4), png.mid(at + 8, length));
        at += length + 12;
    }
}

} // namespace

void AnimatedPng::add(const QImage& picture) {
    const QByteArray control =
        bigEndian(m_sequence++) + bigEndian(static_cast<std::uint32_t>(picture.width())) +
        bigEndian(static_cast<std::uint32_t>(picture.height())) + QByteArray(8, '\0') /* at the corner */ +
        bigEndian(static_cast<std::uint16_t>(m_milliseconds)) + bigEndian(std::uint16_t{1000}) +
        QByteArray(2, '\0') /* kept as it is, drawn over */;
    m_frames += chunk("fcTL", control);
    eachChunk(pngOf(picture), [&](const QByteArray& name, const QByteArray& data) {
        if (name == "IHDR")
            m_header = chunk("IHDR", data);
        else if (name == "IDAT" && m_count == 0)
            m_frames += chunk("IDAT", data);
        else if (name == "IDAT")
            m_frames += chunk("fdAT", bigEndian(m_sequence++) + data);
    });
    ++m_count;
}

QByteArray AnimatedPng::bytes() const {
    if (m_count == 0)
        return {};
    const QByteArray control = bigEndian(static_cast<std::uint32_t>(m_count)) + bigEndian(std::uint32_t{0});
    return signature + m_header + chunk("acTL", control) + m_frames + chunk("IEND", {});
}

} // namespace moldwright
