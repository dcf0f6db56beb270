// SPDX-License-Identifier: AGPL-3.0-or-later
// The one rule of the house: core ← widgets ← app, and inside core a room uses only rooms above it.
#include "support/folders.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <string>
#include <vector>

using namespace moldwright;
namespace fs = std::filesystem;

namespace {

struct Include {
    fs::path file;
    std::string what;
};

std::vector<Include> includesBelow(const fs::path& folder) {
    static const std::regex pattern("^\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"]");
    std::vector<Include> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp")
            continue;
        std::ifstream in(entry.path());
        std::smatch match;
        for (std::string line; std::getline(in, line);)
            if (std::regex_search(line, match, pattern))
                found.push_back({entry.path(), match[1]});
    }
    return found;
}

bool startsWith(const std::string& text, const std::string& start) {
    return text.rfind(start, 0) == 0;
}

const std::vector<std::string> roomsFromTheGroundUp = {
    "base",   "mesh",      "exchange", "castability", "pins",   "deformation", "fill",
    "design", "materials", "features", "mold",        "report", "project"};

} // namespace

TEST(DependencyRule, CoreKnowsNeitherQtNorVtk) {
    for (const Include& include : includesBelow(test::sourceFolder() / "core")) {
        const bool qt = std::regex_match(include.what, std::regex("Q[A-Z].*|Qt.*"));
        EXPECT_FALSE(qt || startsWith(include.what, "vtk")) << include.file << " includes " << include.what;
        EXPECT_FALSE(startsWith(include.what, "widgets/") || startsWith(include.what, "scene/") ||
                     startsWith(include.what, "app/"))
            << include.file << " includes " << include.what;
    }
}

TEST(DependencyRule, OnlyTheWorkerKnowsTetGen) {
    for (const char* room : {"core", "widgets"})
        for (const Include& include : includesBelow(test::sourceFolder() / room))
            EXPECT_NE(include.what, "tetgen.h") << include.file;
}

TEST(DependencyRule, WidgetsDoNotKnowTheApp) {
    for (const Include& include : includesBelow(test::sourceFolder() / "widgets"))
        EXPECT_FALSE(startsWith(include.what, "app/")) << include.file << " includes " << include.what;
}

TEST(DependencyRule, ARoomOfTheCoreUsesOnlyRoomsAboveIt) {
    const auto level = [](const std::string& room) {
        return std::find(roomsFromTheGroundUp.begin(), roomsFromTheGroundUp.end(), room) -
               roomsFromTheGroundUp.begin();
    };
    const fs::path core = test::sourceFolder() / "core";
    int checked = 0;
    for (const Include& include : includesBelow(core)) {
        const std::string room = fs::relative(include.file, core).begin()->string();
        const std::string used = include.what.substr(0, include.what.find('/'));
        const auto rooms = roomsFromTheGroundUp;
        if (std::find(rooms.begin(), rooms.end(), used) == rooms.end())
            continue;
        ++checked;
        EXPECT_LE(level(used), level(room)) << include.file << " includes " << include.what;
    }
    EXPECT_GT(checked, 10);
}

TEST(Resources, EveryIconIsBuiltIn) {
    const fs::path folder = test::sourceFolder() / "resources/icons";
    std::ifstream in(folder / "icons.cmake");
    const std::string list((std::istreambuf_iterator<char>(in)), {});
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".svg") {
            EXPECT_NE(list.find(' ' + entry.path().filename().string()), std::string::npos) << entry.path();
        }
}
