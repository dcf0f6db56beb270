// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/message.h"
#include "base/result.h"
#include "base/task.h"
#include "mesh/indexed_mesh.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace moldwright {

enum class MeshFormat { StlBinary, StlAscii, Obj, Ply, Off };

/// A mesh as read, before any judgement: polygons triangulated, STL corners welded by exact coordinates.
struct ReadMesh {
    IndexedMesh mesh;
    std::vector<Message> notes; ///< what was ignored or mended while reading ("37 spare bytes at the end")
};

/// Reads a mesh file in the worker program, so that no file can crash, stall or exhaust the caller. The
/// format is told by content, then by ending. Units are the file's. Errors: BadInput with a sentence that
/// names the file, what is wrong, and where (line or byte); Cancelled; Worker.
[[nodiscard]] Result<ReadMesh> readMesh(const std::filesystem::path& file, const Task& task = {});

/// The format that a file to be written has by the ending of its name; none where it has another.
[[nodiscard]] std::optional<MeshFormat> formatFor(const std::filesystem::path& file);

/// Writes atomically (temporary file, fsync, rename, fsync of the folder). PLY holds doubles (binary, little
/// endian); binary STL holds floats: what is certified for it must be rounded by roundToFloat() first.
/// Errors: WriteFailed.
[[nodiscard]] Result<void> writeMesh(const std::filesystem::path& file, const IndexedMesh& mesh,
                                     MeshFormat format);

/// Writes a PLY as writeMesh() does, with one more property of each face: `uchar side`, the side of the
/// parting plane that it belongs to. Errors: WriteFailed.
[[nodiscard]] Result<void> writeSidedMesh(const std::filesystem::path& file, const IndexedMesh& mesh,
                                          const std::vector<std::uint8_t>& sides);

/// `mesh` with every coordinate rounded to the nearest float: exactly what a binary STL of it holds.
[[nodiscard]] IndexedMesh roundToFloat(const IndexedMesh& mesh);

/// Makes a folder, and those it lies in, unless it is there. Errors: WriteFailed, naming path and cause.
[[nodiscard]] Result<void> makeFolder(const std::filesystem::path& folder);

/// Writes bytes to a file atomically; an old file stays whole when anything fails. Errors: WriteFailed,
/// naming path and cause.
[[nodiscard]] Result<void> writeFileAtomically(const std::filesystem::path& file, const std::string& bytes);

} // namespace moldwright
