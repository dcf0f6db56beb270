// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/archive.h"

#include <zip.h>

namespace moldwright {

namespace {

// 1 January 1980, 0:00 in the archive's own form, which knows no time zones.
constexpr zip_uint16_t fixedTime = 0;
constexpr zip_uint16_t fixedDate = (1 << 5) + 1;

bool add(zip_t* archive, const ArchiveEntry& entry) {
    zip_source_t* source = zip_source_buffer(archive, entry.bytes.data(), entry.bytes.size(), 0);
    if (!source)
        return false;
    const zip_int64_t index = zip_file_add(archive, entry.name.c_str(), source, ZIP_FL_ENC_UTF_8);
    if (index < 0) {
        zip_source_free(source);
        return false;
    }
    const auto at = static_cast<zip_uint64_t>(index);
    return zip_set_file_compression(archive, at, entry.stored ? ZIP_CM_STORE : ZIP_CM_DEFLATE, 0) == 0 &&
           zip_file_set_dostime(archive, at, fixedTime, fixedDate, 0) == 0;
}

std::string contentOf(zip_source_t* source) {
    zip_stat_t stat;
    std::string bytes;
    if (zip_source_stat(source, &stat) == 0 && zip_source_open(source) == 0) {
        bytes.resize(stat.size);
        const zip_int64_t count = zip_source_read(source, bytes.data(), stat.size);
        bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
        zip_source_close(source);
    }
    return bytes;
}

} // namespace

Result<std::string> archiveBytes(const std::vector<ArchiveEntry>& entries) {
    const auto fail = [] {
        return failure(ErrorCode::Internal,
                       MW_TEXT("Project", "The project file could not be put together."));
    };
    zip_source_t* target = zip_source_buffer_create(nullptr, 0, 0, nullptr);
    if (!target)
        return fail();
    zip_source_keep(target);
    const std::unique_ptr<zip_source_t, decltype(&zip_source_free)> owner(target, &zip_source_free);
    zip_t* archive = zip_open_from_source(target, ZIP_TRUNCATE, nullptr);
    if (!archive) {
        zip_source_free(target);
        return fail();
    }
    bool complete = true;
    for (const ArchiveEntry& entry : entries)
        complete = complete && add(archive, entry);
    if (!complete || zip_close(archive) != 0) {
        zip_discard(archive);
        return fail();
    }
    return contentOf(target);
}

ArchiveReader::ArchiveReader(void* archive)
    : m_archive(archive, [](void* open) { zip_discard(static_cast<zip_t*>(open)); }) {}

std::optional<ArchiveReader> ArchiveReader::open(const std::string& bytes) {
    zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, nullptr);
    if (!source)
        return std::nullopt;
    zip_t* archive = zip_open_from_source(source, ZIP_RDONLY, nullptr);
    if (!archive) {
        zip_source_free(source);
        return std::nullopt;
    }
    return ArchiveReader(archive);
}

bool ArchiveReader::has(const std::string& name) const {
    return zip_name_locate(static_cast<zip_t*>(m_archive.get()), name.c_str(), 0) >= 0;
}

std::optional<std::string> ArchiveReader::read(const std::string& name, std::size_t limit) const {
    zip_file_t* part = zip_fopen(static_cast<zip_t*>(m_archive.get()), name.c_str(), 0);
    if (!part)
        return std::nullopt;
    std::string bytes;
    std::vector<char> buffer(1 << 16);
    zip_int64_t count = 0;
    while (bytes.size() <= limit && (count = zip_fread(part, buffer.data(), buffer.size())) > 0)
        bytes.append(buffer.data(), static_cast<std::size_t>(count));
    zip_fclose(part);
    if (count < 0 || bytes.size() > limit)
        return std::nullopt;
    return bytes;
}

} // namespace moldwright
