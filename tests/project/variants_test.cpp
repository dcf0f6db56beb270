// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/variants.h"

#include "project/edits.h"
#include "project/some_project.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

using namespace moldwright;
using namespace moldwright::test;

namespace {

std::vector<std::string> names(const Project& project) {
    std::vector<std::string> result;
    for (std::size_t i = 0; i < variantCount(project); ++i)
        result.push_back(variantAt(project, i).variantName);
    return result;
}

/// All of a variant but its name.
Variant unnamed(Variant variant) {
    variant.variantName.clear();
    return variant;
}

} // namespace

TEST(Variants, AProjectHasOne) {
    const Project project = someProject();
    EXPECT_EQ(variantCount(project), 1U);
    EXPECT_EQ(variantNames(project), "A");
    EXPECT_EQ(withoutVariant(project, 0), project);
    EXPECT_EQ(withVariant(project, 0), project);
}

TEST(Variants, ADuplicateIsTheSameDesignAndBecomesTheCurrentOne) {
    const Project one = someProject();
    const Project two = withDuplicate(one, 0);
    EXPECT_EQ(names(two), (std::vector<std::string>{"A", "B"}));
    EXPECT_EQ(two.place, 1U);
    EXPECT_EQ(two.cast, one.cast); // shared, not copied
    EXPECT_EQ(unnamed(two), unnamed(variantAt(two, 0)));
    // The copy stands beside what it is a copy of.
    EXPECT_EQ(names(withDuplicate(two, 0)), (std::vector<std::string>{"A", "C", "B"}));
}

TEST(Variants, AnEditChangesTheCurrentOneAlone) {
    const Project two = withPins(withDuplicate(someProject(), 0), {});
    EXPECT_EQ(variantAt(two, 1).cast, nullptr);
    EXPECT_NE(variantAt(two, 0).cast, nullptr);
    EXPECT_EQ(variantAt(two, 0).pins, someProject().pins);
}

TEST(Variants, ThereAndBackIsTheSameToTheBit) {
    const Project two = withPins(withDuplicate(someProject(), 0), {});
    const Project there = withVariant(two, 0);
    EXPECT_EQ(there.place, 0U);
    EXPECT_EQ(there.pins, someProject().pins);
    EXPECT_EQ(names(there), names(two));
    EXPECT_EQ(withVariant(there, 1), two);
}

TEST(Variants, AFreshOneKeepsSettingsOnly) {
    const Project fresh = withFreshVariant(someProject());
    EXPECT_EQ(fresh.design, someProject().design);
    EXPECT_EQ(fresh.mold, someProject().mold);
    EXPECT_EQ(fresh.state, someProject().state);
    EXPECT_FALSE(fresh.planeChosenByHand);
    EXPECT_TRUE(fresh.pins.empty() && fresh.undercuts.empty() && fresh.importance.empty());
    EXPECT_EQ(fresh.cast, nullptr);
}

TEST(Variants, NamesStayDifferent) {
    Project project = withDuplicate(someProject(), 0);
    project = withVariantName(project, 0, "  flat back ");
    EXPECT_EQ(names(project), (std::vector<std::string>{"flat back", "B"}));
    EXPECT_EQ(withVariantName(project, 1, "flat back"), project);
    EXPECT_EQ(withVariantName(project, 1, " "), project);
    EXPECT_EQ(freeVariantName(project), "A");
    for (int i = 0; i < 60; ++i)
        project = withFreshVariant(project);
    const std::vector<std::string> all = names(project);
    EXPECT_EQ(std::set<std::string>(all.begin(), all.end()).size(), all.size());
    EXPECT_TRUE(variantNamed(project, "A2").has_value());
    EXPECT_FALSE(variantNamed(project, "none").has_value());
}

TEST(Variants, RemovingTheCurrentOneMakesItsNeighbourCurrent) {
    const Project three = withFreshVariant(withDuplicate(someProject(), 0)); // A, B, C, the last current
    EXPECT_EQ(withoutVariant(three, 2).variantName, "B");
    EXPECT_EQ(withoutVariant(three, 0).variantName, "C");
    EXPECT_EQ(withoutVariant(three, 0).place, 1U);
    EXPECT_EQ(withoutVariant(withVariant(three, 0), 0).variantName, "B");
}

TEST(Variants, AllMoveWithThePart) {
    const Project two = withDuplicate(someProject(), 0);
    Placement placement = two.placement;
    placement.motion.pretranslate(Eigen::Vector3d(4, 5, 6));
    const Project moved = withPlacement(two, placement);
    EXPECT_NE(moved.state, two.state);
    EXPECT_EQ(unnamed(variantAt(moved, 0)), unnamed(moved));
    EXPECT_EQ(variantAt(moved, 0).cast, nullptr);
}

TEST(Variants, AnotherPartHasOneAgain) {
    const Project two = withDuplicate(someProject(), 0);
    const Project other = withPart(two, "x", "x.stl", two.source, {});
    EXPECT_EQ(names(other), std::vector<std::string>{"A"});
    EXPECT_EQ(other.place, 0U);
}

TEST(Variants, AnyWalkKeepsEachVariantByItsName) {
    // Beside the project a plain list of name and draft, and which of them is current.
    Project project = someProject();
    std::vector<std::pair<std::string, double>> list = {{"A", project.design.draftDegrees}};
    std::size_t current = 0;
    std::mt19937 random(7);
    for (int step = 0; step < 2000; ++step) {
        const std::size_t number = random() % list.size();
        switch (random() % 5) {
        case 0:
            if (list.size() < 9) {
                const std::string name = freeVariantName(project);
                project = withDuplicate(project, number);
                current = number + 1;
                list.insert(list.begin() + static_cast<std::ptrdiff_t>(current), {name, list[number].second});
            }
            break;
        case 1:
            project = withVariant(project, number);
            current = number;
            break;
        case 2:
            if (list.size() > 1) {
                const std::string kept = list[current].first;
                project = withoutVariant(project, number);
                list.erase(list.begin() + static_cast<std::ptrdiff_t>(number));
                current = number == current
                              ? std::min(current, list.size() - 1)
                              : static_cast<std::size_t>(
                                    std::ranges::find(list, kept, &std::pair<std::string, double>::first) -
                                    list.begin());
            }
            break;
        case 3:
            project = withVariantName(project, number, "v" + std::to_string(step));
            list[number].first = "v" + std::to_string(step);
            break;
        default:
            DesignSettings settings = project.design;
            settings.draftDegrees = step;
            project = withDesignSettings(project, settings);
            list[current].second = step;
        }
        ASSERT_EQ(project.place, current) << step;
        ASSERT_EQ(variantCount(project), list.size()) << step;
        for (std::size_t i = 0; i < list.size(); ++i) {
            ASSERT_EQ(variantAt(project, i).variantName, list[i].first) << step;
            ASSERT_EQ(variantAt(project, i).design.draftDegrees, list[i].second) << step;
        }
    }
}
