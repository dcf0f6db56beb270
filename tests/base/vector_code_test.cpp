// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/vector_code.h"

#include <gtest/gtest.h>

#include <vector>

using namespace moldwright;

TEST(VectorCode, IsNeverWiderThanTheLimit) {
    const VectorCode widest = vectorCode();
    limitVectorCode(VectorCode::Plain);
    EXPECT_EQ(vectorCode(), VectorCode::Plain);
    limitVectorCode(VectorCode::Avx512);
    EXPECT_EQ(vectorCode(), widest);
}

TEST(VectorCode, RunsTheBodyOnEveryPath) {
    for (const VectorCode code : {VectorCode::Plain, VectorCode::Avx2, VectorCode::Avx512}) {
        limitVectorCode(code);
        std::vector<double> x(16, 1.0 / 3);
        double* data = x.data();
        inVectorCode([&] {
            for (int i = 0; i < 16; ++i)
                data[i] = data[i] * 3 + i;
        });
        for (int i = 0; i < 16; ++i)
            EXPECT_EQ(x[static_cast<std::size_t>(i)], 1.0 + i);
    }
    limitVectorCode(VectorCode::Avx512);
}
