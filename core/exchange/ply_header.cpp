// SPDX-License-Identifier: AGPL-3.0-or-later
#include "exchange/ply_header.h"

#include "exchange/text_lines.h"

#include <array>
#include <map>

namespace moldwright {

namespace {

const std::map<std::string_view, PlyType> typeNames = {
    {"char", PlyType::Int8},     {"int8", PlyType::Int8},     {"uchar", PlyType::UInt8},
    {"uint8", PlyType::UInt8},   {"short", PlyType::Int16},   {"int16", PlyType::Int16},
    {"ushort", PlyType::UInt16}, {"uint16", PlyType::UInt16}, {"int", PlyType::Int32},
    {"int32", PlyType::Int32},   {"uint", PlyType::UInt32},   {"uint32", PlyType::UInt32},
    {"float", PlyType::Float},   {"float32", PlyType::Float}, {"double", PlyType::Double},
    {"float64", PlyType::Double}};

const std::map<std::string_view, PlyEncoding> encodingNames = {
    {"ascii", PlyEncoding::Text},
    {"binary_little_endian", PlyEncoding::LittleEndian},
    {"binary_big_endian", PlyEncoding::BigEndian}};

/// Steps of reading one header; each says whether its line makes sense.
class HeaderReader {
public:
    explicit HeaderReader(PlyHeader& header) : m_header(header) {}

    bool readLine(std::string_view line) {
        const std::string_view keyword = takeWord(line);
        if (keyword == "format")
            return readFormat(line);
        if (keyword == "element")
            return readElement(line);
        if (keyword == "property")
            return readProperty(line);
        return keyword.empty() || keyword == "ply" || keyword == "comment" || keyword == "obj_info";
    }

private:
    bool readFormat(std::string_view line) {
        const auto encoding = encodingNames.find(takeWord(line));
        if (encoding == encodingNames.end() || takeWord(line) != "1.0")
            return false;
        m_header.encoding = encoding->second;
        return true;
    }

    bool readElement(std::string_view line) {
        PlyElement element;
        element.name = takeWord(line);
        const std::optional<long long> count = wholeNumber(takeWord(line));
        if (!count || *count < 0)
            return false;
        element.count = *count;
        m_header.elements.push_back(element);
        return true;
    }

    bool readProperty(std::string_view line) {
        PlyProperty property;
        std::string_view typeName = takeWord(line);
        if (typeName == "list") {
            const auto countType = typeNames.find(takeWord(line));
            if (countType == typeNames.end())
                return false;
            property.countType = countType->second;
            typeName = takeWord(line);
        }
        const auto type = typeNames.find(typeName);
        property.name = takeWord(line);
        if (type == typeNames.end() || property.name.empty() || m_header.elements.empty())
            return false;
        property.type = type->second;
        m_header.elements.back().properties.push_back(property);
        return true;
    }

    PlyHeader& m_header;
};

} // namespace

std::size_t bytesOf(PlyType type) {
    constexpr std::array<std::size_t, 8> sizes = {1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

Result<PlyHeader> readPlyHeader(std::string_view bytes, const std::string& name) {
    PlyHeader header;
    HeaderReader reader(header);
    TextLines lines(bytes);
    while (lines.next()) {
        std::string_view line = lines.line();
        if (takeWord(line) == "end_header") {
            header.body = lines.rest();
            header.lines = lines.number();
            return header;
        }
        if (!reader.readLine(lines.line()))
            return failure(ErrorCode::BadInput,
                           MW_TEXT("exchange",
                                   "{0}, line {1}: “{2}” is not understood in the header of a PLY "
                                   "file of version 1.0."),
                           {name, std::to_string(lines.number()), shown(lines.line())});
    }
    return failure(ErrorCode::BadInput,
                   MW_TEXT("exchange", "{0} ends within its header: the line “end_header” is missing."),
                   {name});
}

} // namespace moldwright
