// SPDX-License-Identifier: AGPL-3.0-or-later
#include "exchange/mesh_file.h"
#include "support/folders.h"

#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <functional>
#include <sstream>

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace moldwright;
namespace fs = std::filesystem;

namespace {

std::string contentsOf(const fs::path& file) {
    std::ostringstream bytes;
    bytes << std::ifstream(file, std::ios::binary).rdbuf();
    return bytes.str();
}

int filesIn(const fs::path& folder) {
    return static_cast<int>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

/// What `work` says, run in a child process whose limits and rights may be taken away.
std::string saidByChild(const std::function<std::string()>& work) {
    int ends[2] = {-1, -1};
    EXPECT_EQ(pipe(ends), 0);
    const pid_t child = fork();
    if (child == 0) {
        const std::string said = work();
        _exit(write(ends[1], said.data(), said.size()) < 0 ? 1 : 0);
    }
    close(ends[1]);
    std::string said;
    char buffer[512];
    for (ssize_t n = 0; (n = read(ends[0], buffer, sizeof buffer)) > 0;)
        said.append(buffer, static_cast<std::size_t>(n));
    close(ends[0]);
    waitpid(child, nullptr, 0);
    return said;
}

std::string errorOf(const Result<void>& result) {
    return result ? "written" : result.error().english();
}

} // namespace

TEST(AtomicFile, WritesAndReplaces) {
    const test::ScratchFolder folder;
    const fs::path file = folder.path() / "деталь.stl";
    ASSERT_TRUE(writeFileAtomically(file, "old"));
    ASSERT_TRUE(writeFileAtomically(file, std::string("new\0bytes", 9)));
    EXPECT_EQ(contentsOf(file), std::string("new\0bytes", 9));
    EXPECT_EQ(filesIn(folder.path()), 1);
}

TEST(AtomicFile, KeepsTheRightsOfTheOldFile) {
    const test::ScratchFolder folder;
    const fs::path file = folder.path() / "a";
    ASSERT_TRUE(writeFileAtomically(file, "old"));
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
    ASSERT_TRUE(writeFileAtomically(file, "new"));
    EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(AtomicFile, ReplacesTheTargetOfALinkNotTheLink) {
    const test::ScratchFolder folder;
    ASSERT_TRUE(writeFileAtomically(folder.path() / "a", "old"));
    fs::create_symlink("a", folder.path() / "link");
    ASSERT_TRUE(writeFileAtomically(folder.path() / "link", "new"));
    EXPECT_TRUE(fs::is_symlink(folder.path() / "link"));
    EXPECT_EQ(contentsOf(folder.path() / "a"), "new");
}

TEST(AtomicFile, WhenTheRoomEndsTheOldFileStaysAndNothingIsLeft) {
    const test::ScratchFolder folder;
    const fs::path file = folder.path() / "a";
    ASSERT_TRUE(writeFileAtomically(file, "old"));
    const std::string said = saidByChild([&] {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit small = {1000, 1000};
        setrlimit(RLIMIT_FSIZE, &small);
        return errorOf(writeFileAtomically(file, std::string(5000, 'x')));
    });
    EXPECT_EQ(said, file.string() + " could not be written: the file would be larger than is allowed here.");
    EXPECT_EQ(contentsOf(file), "old");
    EXPECT_EQ(filesIn(folder.path()), 1);
}

TEST(AtomicFile, AFolderWithoutRightsIsNamed) {
    const test::ScratchFolder folder;
    fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
    const fs::path file = folder.path() / "a";
    const std::string said = saidByChild([&] {
        // Who may write everywhere gives that right up first.
        constexpr uid_t nobody = 65534;
        if (geteuid() == 0 && setuid(nobody) != 0)
            return std::string("still root");
        return errorOf(writeFileAtomically(file, "x"));
    });
    EXPECT_EQ(said, file.string() + " could not be written: you may not write there.");
    fs::permissions(folder.path(), fs::perms::owner_all);
}

TEST(AtomicFile, WhatIsNoPlainFileIsLeftAlone) {
    const test::ScratchFolder folder;
    EXPECT_EQ(errorOf(writeFileAtomically(folder.path(), "x")),
              folder.path().string() + " could not be written: there is a folder of that name.");
    const fs::path pipe = folder.path() / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_FALSE(writeFileAtomically(pipe, "x"));
    EXPECT_TRUE(fs::is_fifo(pipe));
    const auto lost = writeFileAtomically(folder.path() / "nowhere" / "a", "x");
    ASSERT_FALSE(lost);
    EXPECT_EQ(lost.error().code, ErrorCode::WriteFailed);
    EXPECT_NE(lost.error().english().find("the folder does not exist"), std::string::npos);
}
