// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/certificate.h"
#include "mesh/measures.h"
#include "mold/mold.h"
#include "support/casts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>

namespace moldwright::test {

/// A tray of the cast alone.
inline Tray trayOf(const KnownCast& cast) {
    return moldwright::trayOf({std::make_shared<const IndexedMesh>(cast.mesh),
                               labelSides(cast.mesh, cast.state.plane), cast.state});
}

inline Result<Mold> moldOf(const KnownCast& cast, const MoldSettings& settings, double draft = 1) {
    return buildMold(trayOf(cast), draft, settings);
}

/// The mold was built and all of its proof holds.
inline void expectVerified(const Result<Mold>& mold) {
    ASSERT_TRUE(mold.has_value()) << mold.error().english();
    for (const std::string& problem : mold->problems)
        ADD_FAILURE() << problem;
    EXPECT_TRUE(mold->verified()) << mold->castCertificate.reason;
    const double whole =
        mold->half1.volume + mold->half2.volume + volume(*mold->cast) + mold->sprueVolume + mold->otherVolume;
    EXPECT_NEAR(whole, mold->blockVolume, 1e-6 * whole);
}

/// Spout, vents, keys and slits.
inline MoldSettings everyFeature() {
    MoldSettings settings;
    settings.spout.on = true;
    settings.vents.on = true;
    settings.keys.count = 4;
    settings.slits.count = 2;
    return settings;
}

/// How many features of a kind there are.
inline int count(const Mold& mold, const std::string& kind) {
    return static_cast<int>(std::count_if(mold.features.begin(), mold.features.end(),
                                          [&](const MoldFeature& f) { return f.kind == kind; }));
}

} // namespace moldwright::test
