// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/load_part.h"

#include "exchange/mesh_file.h"

namespace moldwright::cli {

Result<IndexedMesh> loadPart(const std::filesystem::path& file, const Session& session) {
    const Result<ReadMesh> read = readMesh(file, session.task());
    if (!read)
        return std::unexpected(read.error());
    Result<PreparedMesh> prepared = prepare(read->mesh, file.filename().string());
    if (!prepared)
        return std::unexpected(std::move(prepared.error()));
    for (const std::vector<Message>& messages : {read->notes, prepared->repairs, prepared->notes})
        for (const Message& message : messages)
            session.out() << message.english() << '\n';
    return std::move(prepared->mesh);
}

} // namespace moldwright::cli
