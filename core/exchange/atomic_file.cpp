// SPDX-License-Identifier: AGPL-3.0-or-later
#include "exchange/mesh_file.h"

#include "base/stop_point.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace moldwright {

namespace fs = std::filesystem;

namespace {

std::string inWords(int cause) {
    switch (cause) {
    case ENOSPC:
        return "the disk is full";
    case EDQUOT:
        return "your share of the disk is used up";
    case EFBIG:
        return "the file would be larger than is allowed here";
    case EACCES:
    case EPERM:
        return "you may not write there";
    case EROFS:
        return "the disk can only be read";
    case ENOENT:
        return "the folder does not exist";
    case EISDIR:
        return "there is a folder of that name";
    case EIO:
        return "the disk reports a fault";
    default:
        return std::generic_category().message(cause);
    }
}

/// A file that is not there until it is whole: written beside its place under another name, then renamed.
class TemporaryFile {
public:
    explicit TemporaryFile(const fs::path& target) : m_path(target.string() + ".XXXXXX") {
        m_file = mkostemp(m_path.data(), O_CLOEXEC);
    }
    ~TemporaryFile() {
        if (m_file >= 0)
            close(m_file);
        if (m_file >= 0 && !m_renamed)
            unlink(m_path.c_str());
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    [[nodiscard]] bool opened() const { return m_file >= 0; }

    /// Onto the disk piece by piece: a long wait for all of it at the end could not be cancelled.
    [[nodiscard]] bool write(std::string_view bytes) const {
        constexpr std::size_t piece = 8 << 20;
        while (!bytes.empty()) {
            stopPoint();
            const ssize_t n = ::write(m_file, bytes.data(), std::min(piece, bytes.size()));
            if (n < 0 && errno != EINTR)
                return false;
            bytes.remove_prefix(n > 0 ? static_cast<std::size_t>(n) : 0);
            if (!bytes.empty() && fdatasync(m_file) != 0)
                return false;
        }
        return true;
    }

    /// The rights that a file made the plain way would get; those of an old file are kept.
    [[nodiscard]] bool takeRightsOf(const fs::path& target) const {
        struct stat old = {};
        const mode_t mask = umask(0);
        umask(mask);
        const mode_t mode = stat(target.c_str(), &old) == 0 ? old.st_mode & 0777U : 0666U & ~mask;
        return fchmod(m_file, mode) == 0;
    }

    [[nodiscard]] bool synchronised() const { return fsync(m_file) == 0; }

    [[nodiscard]] bool renameTo(const fs::path& target) {
        m_renamed = std::rename(m_path.c_str(), target.c_str()) == 0;
        return m_renamed;
    }

private:
    std::string m_path;
    int m_file;
    bool m_renamed = false;
};

/// Makes the rename itself last. Not every file system can: the file is whole either way.
void synchroniseFolder(const fs::path& folder) {
    const int directory = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (directory < 0)
        return;
    fsync(directory);
    close(directory);
}

} // namespace

Result<void> makeFolder(const std::filesystem::path& folder) {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    if (failed)
        return failure(ErrorCode::WriteFailed, MW_TEXT("exchange", "The folder {0} could not be made: {1}."),
                       {folder.string(), failed.message()});
    return {};
}

Result<void> writeFileAtomically(const fs::path& file, const std::string& bytes) {
    // Through a link the target is replaced, not the link.
    std::error_code notThere;
    const fs::path real = fs::canonical(file, notThere);
    const fs::path target = notThere ? fs::absolute(file, notThere) : real;
    if (fs::exists(target, notThere) && !fs::is_regular_file(target, notThere))
        return failure(ErrorCode::WriteFailed, MW_TEXT("exchange", "{0} could not be written: {1}."),
                       {file.string(), inWords(fs::is_directory(target, notThere) ? EISDIR : EPERM)});
    TemporaryFile temporary(target);
    errno = temporary.opened() ? 0 : errno;
    if (temporary.opened() && temporary.write(bytes) && temporary.takeRightsOf(target) &&
        temporary.synchronised() && temporary.renameTo(target)) {
        synchroniseFolder(target.parent_path());
        return {};
    }
    return failure(ErrorCode::WriteFailed, MW_TEXT("exchange", "{0} could not be written: {1}."),
                   {file.string(), inWords(errno)});
}

} // namespace moldwright
