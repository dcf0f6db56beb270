// SPDX-License-Identifier: AGPL-3.0-or-later
#include "exchange/mesh_readers.h"

#include "exchange/text_lines.h"

namespace moldwright {

Result<ReadMesh> readMeshBytes(std::string_view bytes, const std::string& name) {
    if (bytes.empty())
        return failure(ErrorCode::BadInput, MW_TEXT("exchange", "{0} is an empty file."), {name});
    const std::size_t dot = name.rfind('.');
    const std::string ending = dot == std::string::npos ? "" : lowerCase(name.substr(dot));
    if (beginsLikePly(bytes) || ending == ".ply") {
        // Some programs write OFF under any name.
        return beginsLikeOff(bytes) ? readOff(bytes, name) : readPly(bytes, name);
    }
    if (beginsLikeOff(bytes) || ending == ".off")
        return readOff(bytes, name);
    if (ending == ".obj")
        return readObj(bytes, name);
    if (beginsLikeStl(bytes) || ending == ".stl")
        return readStl(bytes, name);
    return failure(ErrorCode::BadInput,
                   MW_TEXT("exchange", "{0} is in no format that Moldwright reads: STL, OBJ, PLY or OFF."),
                   {name});
}

} // namespace moldwright
