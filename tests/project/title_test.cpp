// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/title.h"

#include "project/edits.h"
#include "project/some_project.h"

#include <gtest/gtest.h>

using namespace moldwright;

TEST(Title, IsKeptWithoutBlanksAtItsEnds) {
    const Project before = test::someProject();
    const Project after = withTitle(before, {"  ", " M-1042 ", "B"});
    EXPECT_EQ(after.name, before.name) << "a part has a name";
    EXPECT_EQ(after.number, "M-1042");
    EXPECT_EQ(after.revision, "B");
    EXPECT_EQ(after.cast, before.cast) << "a title is nothing that a cast follows from";
    EXPECT_EQ(withTitle(after, titleOf(after)), after);
}

TEST(Title, OfAPartGoesWithIt) {
    const Project project = withTitle(test::someProject(), {"Box", "M-1042", "B"});
    const Project another = withPart(project, "Ball", "ball.stl", project.source, {});
    EXPECT_EQ(another.number + another.revision, "");
}

TEST(Title, StandsOnThePlaqueOnceItIsBuilt) {
    Project project = withTitle(test::someProject(), {"big_box", "M-1", ""});
    project.mold.plaque.text = "{part} {number}{revision}|{half}";
    EXPECT_EQ(moldAsBuilt(project).plaque.text, "big box M-1|{half}");
    project.revision = "C";
    EXPECT_EQ(moldAsBuilt(project).plaque.text, "big box M-1C|{half}") << "never an old one";
}
