// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace moldwright {

enum class PlyEncoding { Text, LittleEndian, BigEndian };
enum class PlyType { Int8, UInt8, Int16, UInt16, Int32, UInt32, Float, Double };

[[nodiscard]] std::size_t bytesOf(PlyType type);

struct PlyProperty {
    std::string name;
    PlyType type = PlyType::Float;
    std::optional<PlyType> countType; ///< set for a list: the type of its count
};

struct PlyElement {
    std::string name;
    long long count = 0;
    std::vector<PlyProperty> properties;
};

/// What a PLY file announces, in the file's order, and where its body begins.
struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::Text;
    std::vector<PlyElement> elements;
    std::string_view body;
    int lines = 0; ///< of the header
};

/// Reads the header. Errors: BadInput naming file and line.
[[nodiscard]] Result<PlyHeader> readPlyHeader(std::string_view bytes, const std::string& name);

} // namespace moldwright
