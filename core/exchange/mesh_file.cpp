// SPDX-License-Identifier: AGPL-3.0-or-later
#include "exchange/mesh_file.h"

#include "exchange/wire.h"
#include "exchange/worker_client.h"

#include <system_error>

namespace moldwright {

namespace fs = std::filesystem;

namespace {

/// The size of a file that can be read from start to end.
Result<std::uintmax_t> sizeOfFile(const fs::path& file, const std::string& name) {
    std::error_code cause;
    const fs::file_status status = fs::status(file, cause);
    if (status.type() == fs::file_type::not_found)
        return failure(ErrorCode::BadInput, MW_TEXT("exchange", "There is no file {0}."), {file.string()});
    if (fs::is_directory(status))
        return failure(ErrorCode::BadInput, MW_TEXT("exchange", "{0} is a folder, not a mesh file."), {name});
    if (fs::exists(status) && !fs::is_regular_file(status))
        return failure(ErrorCode::BadInput, MW_TEXT("exchange", "{0} is not a plain file."), {name});
    const std::uintmax_t size = cause ? 0 : fs::file_size(file, cause);
    if (cause)
        return failure(ErrorCode::BadInput, MW_TEXT("exchange", "{0} could not be read: {1}."),
                       {name, cause.message()});
    return size;
}

/// A text STL needs most: its corners are kept three times before they are welded. Time follows size as well.
WorkerLimits limitsFor(std::uintmax_t fileSize) {
    const auto megabytes = static_cast<std::int64_t>(fileSize >> 20);
    return {.megabytes = 384 + 24 * megabytes, .seconds = static_cast<int>(20 + megabytes)};
}

Result<ReadMesh> unpacked(const std::string& bytes) {
    WireReader reader(bytes);
    ReadMesh read;
    read.mesh.V = reader.matrix<Points>();
    read.mesh.F = reader.matrix<Triangles>();
    for (std::int64_t notes = reader.number(); notes > 0 && reader.whole(); --notes)
        read.notes.push_back(reader.message());
    const bool indicesFit = read.mesh.F.size() == 0 ||
                            (read.mesh.F.minCoeff() >= 0 && read.mesh.F.maxCoeff() < read.mesh.vertexCount());
    if (!reader.whole() || !indicesFit || !read.mesh.V.allFinite())
        return failure(ErrorCode::Worker, MW_TEXT("exchange", "The worker program's answer is incomplete."));
    return read;
}

} // namespace

Result<ReadMesh> readMesh(const fs::path& file, const Task& task) {
    const std::string name = file.filename().string();
    const Result<std::uintmax_t> size = sizeOfFile(file, name);
    if (!size)
        return std::unexpected(size.error());
    WireWriter request;
    request.text(file.string());
    request.text(name);
    const Result<std::string> answer =
        askWorker(WorkerJob::ReadMesh, request.bytes(), limitsFor(*size), task);
    if (!answer)
        return std::unexpected(answer.error());
    return unpacked(*answer);
}

} // namespace moldwright
