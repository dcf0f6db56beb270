// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/contacts.h"

#include "deformation/two_bodies.h"

#include <gtest/gtest.h>

using namespace moldwright;

namespace {

/// Two slabs, one `apart` over the other.
BodyShape slabs(double apart) {
    const test::Solid low = test::solidBox({0, 0, 0}, {1, 1, 0.1}, {8, 8, 1});
    const test::Solid high = test::solidBox({0, 0, 0.1 + apart}, {1, 1, 0.2 + apart}, {8, 8, 1});
    return test::besideEachOther(low, high);
}

} // namespace

TEST(Contacts, ThereAreNoneAtRestHoweverNearOrThin) {
    const BodyShape body = slabs(0.02);
    EXPECT_TRUE(contactsAt(body, body.V, 0.3).empty());
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(1, Eigen::Vector3d(1, 2, 3).normalized()).matrix();
    EXPECT_TRUE(contactsAt(body, body.V * turn.transpose(), 0.3).empty());
}

TEST(Contacts, SurfacesThatCameTogetherArePushedApartAcrossTheirGap) {
    const BodyShape body = slabs(0.3);
    const double gap = 0.1;
    for (const double now : {0.08, 0.02, -0.03}) { // apart, all but touching, one in the other
        Positions X = body.V;
        X.bottomRows(X.rows() / 2).col(2).array() += now - 0.3;
        const std::vector<Contact> contacts = contactsAt(body, X, gap);
        ASSERT_FALSE(contacts.empty());
        for (const Contact& contact : contacts) {
            const bool fromHigh = contact.a >= X.rows() / 2;
            EXPECT_EQ(contact.b >= X.rows() / 2, !fromHigh);
            EXPECT_GT((fromHigh ? 1 : -1) * contact.away.z(), 0.7);
            EXPECT_EQ(contact.gap, gap);
        }
    }
}

TEST(Contacts, SurfacesFartherApartThanTheGapAreNone) {
    const BodyShape body = slabs(0.5);
    Positions X = body.V;
    X.bottomRows(X.rows() / 2).col(2).array() -= 0.35;
    EXPECT_TRUE(contactsAt(body, X, 0.1).empty());
    EXPECT_FALSE(contactsAt(body, X, 0.2).empty());
}
