// SPDX-License-Identifier: AGPL-3.0-or-later
// Algorithm 1, unattended, on real parts: castable at one degree, and still the same part.
#include "design/design.h"

#include "exchange/mesh_file.h"
#include "mesh/check.h"
#include "support/folders.h"

#include <gtest/gtest.h>

using namespace moldwright;

namespace {

class RealModel : public testing::TestWithParam<const char*> {};

} // namespace

TEST_P(RealModel, BecomesCastableAndStaysItself) {
    const auto folder = test::models();
    if (!folder)
        GTEST_SKIP() << "MOLDWRIGHT_MODELS is not set";
    const Result<ReadMesh> read = readMesh(*folder / GetParam());
    ASSERT_TRUE(read) << read.error().english();
    const Result<PreparedMesh> part = prepare(read->mesh, GetParam());
    ASSERT_TRUE(part) << part.error().english();
    DesignRequest request;
    request.part = std::make_shared<const IndexedMesh>(part->mesh);
    const Result<DesignResult> result = design(request);
    ASSERT_TRUE(result) << result.error().english();
    ASSERT_TRUE(result->castable) << result->certificate.reason;
    const Certificate proof = certify(*result->cast, labelSides(*result->cast, result->state.plane),
                                      result->state, request.draftDegrees);
    EXPECT_TRUE(proof.holds()) << proof.reason;
    EXPECT_LE(result->change.meanDistance, 0.01);
    RecordProperty("mean_distance_percent", std::to_string(100 * result->change.meanDistance));
}

INSTANTIATE_TEST_SUITE_P(Small, RealModel,
                         testing::Values("beam.stl", "bunny.stl", "goathead.stl", "spot.obj"));
