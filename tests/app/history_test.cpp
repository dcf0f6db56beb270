// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/history.h"

#include "project/edits.h"
#include "project/further_parts.h"
#include "project/variants.h"
#include "support/casts.h"

#include <gtest/gtest.h>

using namespace moldwright;
using namespace moldwright::test;
using namespace Qt::StringLiterals;

namespace {

SharedMesh someMesh() {
    return std::make_shared<const IndexedMesh>(ball(10, 4).mesh);
}

Project withCastOf(Project project, const SharedMesh& mesh) {
    CastResult cast;
    cast.mesh = mesh;
    cast.before = mesh->V;
    project.cast = std::make_shared<const CastResult>(cast);
    return project;
}

} // namespace

TEST(History, CountsWhatVariantsShareOnce) {
    const SharedMesh mesh = someMesh();
    const Project one = withCastOf(withPart({}, "x", "x.stl", mesh, {}), someMesh());
    const Project two = withDuplicate(one, 0);
    History history;
    history.push({u"Duplicate"_s, one, two, {}});
    const std::size_t shared = history.bytes();
    history.push({u"Deform"_s, two, withCastOf(two, someMesh()), {}});
    const std::size_t cast = static_cast<std::size_t>(mesh->V.size()) * sizeof(double);
    EXPECT_GT(history.bytes(), shared + cast);
    history.push({u"Choose"_s, two, withVariant(two, 0), {}});
    EXPECT_LT(history.bytes(), shared + 4 * cast);
}

TEST(History, CountsFurtherPartsOfAMoldOnce) {
    const SharedMesh mesh = someMesh();
    const Project one = withPart({}, "x", "x.stl", mesh, {});
    const TrayPart part{std::make_shared<const CertifiedCast>(CertifiedCast{someMesh(), {}, {}}), "y", {}, 1};
    const Project two = withFurtherPart(one, part);
    History history;
    history.push({u"Add y"_s, one, two, {}});
    const std::size_t before = history.bytes();
    const std::size_t cast = static_cast<std::size_t>(mesh->V.size()) * sizeof(double);
    History without;
    without.push({u"Rename"_s, one, one, {}});
    EXPECT_GT(before, without.bytes() + cast);
    history.push({u"Count"_s, two, withFurtherCount(two, 0, 2), {}});
    EXPECT_LT(history.bytes(), before + cast);
}

TEST(History, TheOldestStepsGoWhereVariantsNeedTheMemory) {
    const Project one = withCastOf(withPart({}, "x", "x.stl", someMesh(), {}), someMesh());
    History all;
    all.push({u"First"_s, one, withDuplicate(one, 0), {}});
    History history(5 * all.bytes());
    Project project = one;
    for (int i = 0; i < 20; ++i) {
        const Project next = withCastOf(withDuplicate(project, 0), someMesh());
        history.push({u"Duplicate"_s, project, next, {}});
        project = next;
    }
    EXPECT_LT(history.steps().size(), 20U);
    EXPECT_EQ(history.undo(), history.steps().back().before);
}
