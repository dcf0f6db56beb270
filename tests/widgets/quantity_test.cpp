// SPDX-License-Identifier: AGPL-3.0-or-later
#include "panels/quantity_spin_box.h"

#include <gtest/gtest.h>

using moldwright::quantityFromText;

TEST(Quantity, SumsFractionsAndUnits) {
    const QString mm = QStringLiteral("mm");
    EXPECT_DOUBLE_EQ(quantityFromText(QStringLiteral("1/2 in"), mm).value(), 12.7);
    EXPECT_DOUBLE_EQ(quantityFromText(QStringLiteral("2 in mm"), mm).value(), 50.8);
    EXPECT_DOUBLE_EQ(quantityFromText(QStringLiteral("3*4"), mm).value(), 12);
    EXPECT_DOUBLE_EQ(quantityFromText(QStringLiteral("10 + 2.5 mm"), mm).value(), 12.5);
    EXPECT_DOUBLE_EQ(quantityFromText(QStringLiteral("2 cm"), mm).value(), 20);
    EXPECT_DOUBLE_EQ(quantityFromText(QStringLiteral("−3,5 mm"), mm).value(), -3.5);
    EXPECT_DOUBLE_EQ(quantityFromText(QStringLiteral("1.5°"), QStringLiteral("°")).value(), 1.5);
}

TEST(Quantity, NonsenseIsNoNumber) {
    for (const char* text : {"", "mm", "abc", "3*", "1/0", "3 ft"})
        EXPECT_FALSE(quantityFromText(QString::fromLatin1(text), QStringLiteral("mm"))) << text;
}
