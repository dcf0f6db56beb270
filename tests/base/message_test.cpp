// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/message.h"

#include <gtest/gtest.h>

using namespace moldwright;

TEST(Message, FillsPlacesInAnyOrder) {
    const Message message{"{1} before {0}, {1} again", {"a", "b"}};
    EXPECT_EQ(message.english(), "b before a, b again");
    EXPECT_EQ(message.fill("{0}-{1}"), "a-b");
}

TEST(Message, LeavesBracesThatAreNoPlaces) {
    EXPECT_EQ((Message{"{x} {0", {"a"}}.english()), "{x} {0");
    EXPECT_EQ((Message{"{3}", {"a"}}.english()), "");
}

TEST(Message, ReadableNumbersHaveNoTrailingZeros) {
    EXPECT_EQ(readable(1.5), "1.5");
    EXPECT_EQ(readable(80.0), "80");
    EXPECT_EQ(readable(0.123456), "0.1235");
}
