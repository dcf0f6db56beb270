// SPDX-License-Identifier: AGPL-3.0-or-later
#include "exchange/mesh_readers.h"
#include "exchange/wire.h"
#include "worker/jobs.h"

#include <array>
#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace moldwright {

namespace {

Result<std::string> bytesOf(const std::string& path, const std::string& name) {
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    std::string bytes;
    std::array<char, 1 << 16> buffer;
    ssize_t n = file < 0 ? -1 : 0;
    while (file >= 0 && (n = read(file, buffer.data(), buffer.size())) > 0)
        bytes.append(buffer.data(), static_cast<std::size_t>(n));
    const int cause = errno;
    if (file >= 0)
        close(file);
    if (n < 0)
        return failure(ErrorCode::BadInput, MW_TEXT("exchange", "{0} could not be read: {1}."),
                       {name, std::generic_category().message(cause)});
    return bytes;
}

} // namespace

Result<std::string> readMeshJob(const std::string& request) {
    WireReader reader(request);
    const std::string path = reader.text();
    const std::string name = reader.text();
    if (!reader.whole())
        return failure(ErrorCode::Worker, MW_TEXT("exchange", "The worker program was asked for nothing."));
    const Result<std::string> bytes = bytesOf(path, name);
    if (!bytes)
        return bytes;
    const Result<ReadMesh> read = readMeshBytes(*bytes, name);
    if (!read)
        return std::unexpected(read.error());
    WireWriter answer;
    answer.matrix(read->mesh.V);
    answer.matrix(read->mesh.F);
    answer.number(static_cast<std::int64_t>(read->notes.size()));
    for (const Message& note : read->notes)
        answer.message(note);
    return answer.bytes();
}

} // namespace moldwright
