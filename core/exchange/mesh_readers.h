// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "exchange/mesh_file.h"

#include <string>
#include <string_view>

namespace moldwright {

/// The readers behind readMesh(). Each takes the bytes of a whole file and `name`, the file's name for
/// sentences. Nothing is allocated for what a header merely announces: memory follows the bytes that are
/// there. Errors: BadInput, naming the file, what is wrong and where (line, byte, or number of the element).

/// Tells the format by content, then by the ending of `name`, and reads.
[[nodiscard]] Result<ReadMesh> readMeshBytes(std::string_view bytes, const std::string& name);

/// STL, binary or text. Corners with equal coordinates become one point; stored normals are ignored.
[[nodiscard]] Result<ReadMesh> readStl(std::string_view bytes, const std::string& name);

/// Wavefront OBJ: v and f, with negative indices and continued lines; everything else is ignored.
[[nodiscard]] Result<ReadMesh> readObj(std::string_view bytes, const std::string& name);

/// PLY 1.0, text and binary of both byte orders: any elements and properties in any order.
[[nodiscard]] Result<ReadMesh> readPly(std::string_view bytes, const std::string& name);

/// Object File Format in text: OFF, COFF, NOFF, STOFF and their mixtures; colours and normals are ignored.
[[nodiscard]] Result<ReadMesh> readOff(std::string_view bytes, const std::string& name);

/// True when `bytes` begin as a file of that format does.
[[nodiscard]] bool beginsLikePly(std::string_view bytes);
[[nodiscard]] bool beginsLikeOff(std::string_view bytes);
[[nodiscard]] bool beginsLikeStl(std::string_view bytes);

} // namespace moldwright
