// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/animated_png.h"

#include <QtEndian>

#include <gtest/gtest.h>

#include <string>
#include <vector>

using namespace moldwright;

namespace {

QImage plain(QColor colour) {
    QImage picture(20, 10, QImage::Format_RGB32);
    picture.fill(colour);
    return picture;
}

struct Chunk {
    std::string name;
    QByteArray data;
};

std::vector<Chunk> chunksOf(const QByteArray& png) {
    std::vector<Chunk> chunks;
    for (qsizetype at = 8; at + 12 <= png.size();) {
        const auto length = static_cast<qsizetype>(qFromBigEndian<quint32>(png.constData() + at));
        chunks.push_back({png.mid(at + 4, 4).toStdString(), png.mid(at + 8, length)});
        at += length + 12;
    }
    return chunks;
}

} // namespace

TEST(AnimatedPng, APlainViewerShowsTheFirstPicture) {
    AnimatedPng animation(50);
    EXPECT_TRUE(animation.bytes().isEmpty());
    animation.add(plain(Qt::red));
    animation.add(plain(Qt::blue));
    QImage seen;
    ASSERT_TRUE(seen.loadFromData(animation.bytes(), "PNG")) << "its checksums are right";
    EXPECT_EQ(seen.size(), QSize(20, 10));
    EXPECT_EQ(seen.pixelColor(3, 3), QColor(Qt::red));
}

TEST(AnimatedPng, EveryPictureHasItsControlAndTheNumbersRunOn) {
    AnimatedPng animation(40);
    for (const QColor& colour : {QColor(Qt::red), QColor(Qt::green), QColor(Qt::blue)})
        animation.add(plain(colour));
    const std::vector<Chunk> chunks = chunksOf(animation.bytes());
    ASSERT_GE(chunks.size(), 9U);
    EXPECT_EQ(chunks[0].name, "IHDR");
    EXPECT_EQ(chunks[1].name, "acTL");
    EXPECT_EQ(qFromBigEndian<quint32>(chunks[1].data.constData()), 3U);
    EXPECT_EQ(chunks.back().name, "IEND");
    quint32 next = 0;
    int controls = 0;
    for (const Chunk& chunk : chunks) {
        if (chunk.name != "fcTL" && chunk.name != "fdAT")
            continue;
        EXPECT_EQ(qFromBigEndian<quint32>(chunk.data.constData()), next++);
        if (chunk.name == "fcTL") {
            ++controls;
            EXPECT_EQ(qFromBigEndian<quint16>(chunk.data.constData() + 20), 40U);
        }
    }
    EXPECT_EQ(controls, 3);
}

TEST(AnimatedPng, ThePictureBehindADataChunkIsThePicture) {
    AnimatedPng animation(40);
    animation.add(plain(Qt::red));
    animation.add(plain(Qt::blue));
    // The second picture's data, put in the first one's place.
    AnimatedPng alone(40);
    alone.add(plain(Qt::blue));
    QByteArray first;
    QByteArray second;
    for (const Chunk& chunk : chunksOf(alone.bytes()))
        if (chunk.name == "IDAT")
            first += chunk.data;
    for (const Chunk& chunk : chunksOf(animation.bytes()))
        if (chunk.name == "fdAT")
            second += chunk.data.mid(4);
    EXPECT_EQ(first, second);
}
