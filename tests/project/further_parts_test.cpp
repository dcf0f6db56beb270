// SPDX-License-Identifier: AGPL-3.0-or-later
// Further parts of a mold: read from projects, edited, and what other edits leave of them.
#include "project/further_parts.h"

#include "project/edits.h"
#include "project/project_file.h"
#include "project/some_project.h"
#include "project/variants.h"
#include "support/casts.h"
#include "support/folders.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

using namespace moldwright;
using namespace moldwright::test;

namespace {

std::string save(const std::filesystem::path& file, const Project& project) {
    std::filesystem::create_directories(file.parent_path());
    EXPECT_TRUE(saveProject(file, {project, "", ""}).has_value());
    return file.string();
}

std::string refusal(const Result<TrayPart>& part) {
    return part ? std::string() : part.error().english();
}

} // namespace

TEST(FurtherParts, AreReadFromFilesAndFolders) {
    const ScratchFolder folder;
    const Project box = someProject(); // "Box ∅ 20"
    const std::string file = save(folder.path() / "blocks" / "one.moldwright", box);
    save(folder.path() / "two" / "project.moldwright", box);
    const Result<TrayPart> part = readTrayPart(file, {"fish"});
    ASSERT_TRUE(part.has_value()) << refusal(part);
    EXPECT_EQ(part->cast->mesh->V, box.cast->mesh->V);
    EXPECT_EQ(part->cast->labels, box.cast->labels);
    EXPECT_EQ(part->cast->state, box.cast->state);
    EXPECT_EQ(part->name, box.name);
    EXPECT_EQ(part->source, file);
    EXPECT_EQ(part->count, 1);
    EXPECT_EQ(readTrayPart(file, {box.name})->name, "one") << "its own is taken";
    EXPECT_EQ(readTrayPart(file, {box.name, "one"})->name, "one 2");
    EXPECT_EQ(readTrayPart(folder.path() / "two", {})->name, box.name);
    EXPECT_EQ(readTrayPart(folder.path() / "two", {box.name})->name, "two");
    EXPECT_EQ(readTrayPart(folder.path() / "two" / "", {box.name})->name, "two");
    EXPECT_EQ(readTrayPart(folder.path() / "two" / "project.moldwright", {box.name})->name, "two");
}

TEST(FurtherParts, WithoutACastNothingIsRead) {
    const ScratchFolder folder;
    const std::string file = save(folder.path() / "raw.moldwright", withPins(someProject(), {}));
    const Result<TrayPart> part = readTrayPart(file, {});
    ASSERT_FALSE(part.has_value());
    EXPECT_EQ(part.error().code, ErrorCode::BadInput);
    EXPECT_NE(refusal(part).find("no finished cast"), std::string::npos);
    EXPECT_NE(refusal(part).find(file), std::string::npos);
    EXPECT_NE(refusal(readTrayPart(folder.path() / "none.moldwright", {})).find("none.moldwright"),
              std::string::npos);
}

TEST(FurtherParts, StandInTheTrayAfterTheCast) {
    const Project project = someTrays();
    const Tray tray = trayOf(project, project.name);
    ASSERT_EQ(tray.size(), 3U);
    EXPECT_EQ(tray[0].cast, project.cast);
    EXPECT_EQ(tray[1], project.furtherParts[0]);
    EXPECT_EQ(tray[2].count, 3);
    EXPECT_EQ(namesTaken(tray), (std::vector<std::string>{project.name, "ring", "ball ∅"}));
    EXPECT_EQ(namesOf(tray), project.name + ", ring, ball ∅");
}

TEST(FurtherParts, EditsChangeTheOneTheyAreFor) {
    const Project two = someTrays();
    EXPECT_EQ(withFurtherCount(two, 0, 7).furtherParts[0].count, 7);
    EXPECT_EQ(withFurtherCount(two, 0, 7).furtherParts[1], two.furtherParts[1]);
    EXPECT_EQ(withFurtherCount(two, 0, 0).furtherParts[0].count, 1);
    EXPECT_EQ(withFurtherCount(two, 0, 1000).furtherParts[0].count, mostCavities);
    EXPECT_EQ(withFurtherName(two, 1, "pearl").furtherParts[1].name, "pearl");
    EXPECT_EQ(withFurtherName(two, 1, ""), two);
    const Project one = withoutFurtherPart(two, 0);
    ASSERT_EQ(one.furtherParts.size(), 1U);
    EXPECT_EQ(one.furtherParts[0], two.furtherParts[1]);
    EXPECT_EQ(one.cast, two.cast) << "they are the mold's, not the cast's";
}

TEST(FurtherParts, ReadAgainTheyAreOthersOnlyWhereAValueDiffers) {
    const Project two = someTrays();
    CertifiedCast cast = *two.furtherParts[0].cast;
    EXPECT_EQ(withFurtherCast(two, 0, std::make_shared<const CertifiedCast>(cast)), two);
    IndexedMesh mesh = *cast.mesh;
    mesh.V(3, 1) = std::nextafter(mesh.V(3, 1), 1000);
    cast.mesh = std::make_shared<const IndexedMesh>(mesh);
    const Project changed = withFurtherCast(two, 0, std::make_shared<const CertifiedCast>(cast));
    EXPECT_EQ(changed.furtherParts[0].cast->mesh, cast.mesh);
    EXPECT_EQ(changed.furtherParts[0].name, "ring");
    EXPECT_EQ(variantAt(changed, 0).furtherParts, variantAt(two, 0).furtherParts);
}

TEST(FurtherParts, StayWhenTheCastGoesAndGoWithThePart) {
    const Project two = someTrays();
    const Project bare = withPins(two, {});
    EXPECT_EQ(bare.cast, nullptr);
    EXPECT_EQ(bare.furtherParts, two.furtherParts);
    Placement placement = two.placement;
    placement.scale *= 2;
    EXPECT_EQ(withPlacement(two, placement).furtherParts, two.furtherParts)
        << "each lies in a frame of its own";
    EXPECT_EQ(withDuplicate(two, two.place).furtherParts, two.furtherParts);
    EXPECT_EQ(withFreshVariant(two).furtherParts, two.furtherParts);
    EXPECT_TRUE(withPart(two, "other", "", two.source, {}).furtherParts.empty());
}

TEST(FurtherParts, LeastDraftIsThatOfTheSteepestFace) {
    for (const double lean : {0.1, -0.05}) {
        const KnownCast cast = frusta(20, 10, 5, 3, lean);
        const SideLabels labels = labelSides(cast.mesh, cast.state.plane);
        EXPECT_NEAR(leastDraftDegrees({std::make_shared<const IndexedMesh>(cast.mesh), labels, cast.state}),
                    degrees(std::atan(lean)), 1e-9);
    }
}
