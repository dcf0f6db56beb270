// SPDX-License-Identifier: AGPL-3.0-or-later
#include "exchange/mesh_readers.h"
#include "exchange/ply_header.h"
#include "exchange/soup_builder.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace moldwright {

namespace {

/// The numbers of a PLY body, one after the other, whatever their encoding.
class PlyNumbers {
public:
    explicit PlyNumbers(const PlyHeader& header) : m_encoding(header.encoding), m_bytes(header.body) {}

    /// The next number; none at the end of the file, not-a-number where something else stands.
    std::optional<double> next(PlyType type) {
        return m_encoding == PlyEncoding::Text ? nextWord() : nextBinary(type);
    }

    [[nodiscard]] std::size_t bytesLeft() const { return m_bytes.size(); }

private:
    std::optional<double> nextWord() {
        constexpr std::string_view blanks = " \t\v\f\r\n";
        m_bytes.remove_prefix(std::min(m_bytes.find_first_not_of(blanks), m_bytes.size()));
        const std::string_view word = m_bytes.substr(0, m_bytes.find_first_of(blanks));
        m_bytes.remove_prefix(word.size());
        if (word.empty())
            return std::nullopt;
        return realNumber(word).value_or(std::nan(""));
    }

    std::optional<double> nextBinary(PlyType type) {
        std::array<char, 8> raw = {};
        const std::size_t size = bytesOf(type);
        if (m_bytes.size() < size)
            return std::nullopt;
        std::copy_n(m_bytes.begin(), size, raw.begin());
        m_bytes.remove_prefix(size);
        const bool reversed =
            (m_encoding == PlyEncoding::BigEndian) != (std::endian::native == std::endian::big);
        if (reversed)
            std::reverse(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(size));
        return decoded(raw, type);
    }

    template <class T>
    static double as(const std::array<char, 8>& raw) {
        T value;
        std::memcpy(&value, raw.data(), sizeof value);
        return static_cast<double>(value);
    }

    static double decoded(const std::array<char, 8>& raw, PlyType type) {
        switch (type) {
        case PlyType::Int8:
            return as<std::int8_t>(raw);
        case PlyType::UInt8:
            return as<std::uint8_t>(raw);
        case PlyType::Int16:
            return as<std::int16_t>(raw);
        case PlyType::UInt16:
            return as<std::uint16_t>(raw);
        case PlyType::Int32:
            return as<std::int32_t>(raw);
        case PlyType::UInt32:
            return as<std::uint32_t>(raw);
        case PlyType::Float:
            return as<float>(raw);
        case PlyType::Double:
            break;
        }
        return as<double>(raw);
    }

    PlyEncoding m_encoding;
    std::string_view m_bytes;
};

/// Reads a body as its header says: the corners from the faces' list of points, x, y and z from the vertices;
/// all other elements and properties are read over.
class PlyReader {
public:
    PlyReader(const PlyHeader& header, const std::string& name)
        : m_header(header), m_numbers(header), m_builder(name) {}

    Result<ReadMesh> read() {
        for (const PlyElement& element : m_header.elements)
            if (!fits(element) || !readAll(element))
                break;
        if (!m_builder.failed() && m_header.encoding != PlyEncoding::Text && m_numbers.bytesLeft() > 0)
            m_builder.note(MW_TEXT("exchange", "{0} spare bytes at the end were ignored."),
                           {std::to_string(m_numbers.bytesLeft())});
        return std::move(m_builder).finish();
    }

private:
    /// Refuses what Moldwright does not read and counts that the file is too short for.
    bool fits(const PlyElement& element) {
        if (element.name == "tristrips" && element.count > 0)
            return m_builder.refuse(MW_TEXT("exchange",
                                            "{0} holds its surface as tristrips (strips of triangles). "
                                            "Save it with plain faces."));
        std::size_t smallest = 0;
        for (const PlyProperty& property : element.properties)
            smallest += m_header.encoding == PlyEncoding::Text
                            ? 1
                            : bytesOf(property.countType.value_or(property.type));
        if (smallest == 0 || static_cast<std::size_t>(element.count) <= m_numbers.bytesLeft() / smallest)
            return true;
        return m_builder.refuse(
            MW_TEXT("exchange", "{0} announces {1} times “{2}” but is too short to hold them."),
            {std::to_string(element.count), shown(element.name)});
    }

    bool readAll(const PlyElement& element) {
        const bool isVertex = element.name == "vertex";
        for (long long i = 0; i < element.count && !element.properties.empty(); ++i) {
            m_where = element.name + " " + std::to_string(i);
            m_point = Eigen::Vector3d::Constant(std::nan(""));
            for (const PlyProperty& property : element.properties)
                if (!(property.countType ? readList(element, property) : readNumber(property)))
                    return false;
            if (isVertex && !m_builder.addPoint(m_point, m_where))
                return false;
        }
        return true;
    }

    bool refuseHere() {
        return m_builder.refuse(MW_TEXT("exchange",
                                        "{0}, {1}: a number is missing here, not finite, or not a "
                                        "number. The file may be cut off."),
                                {shown(m_where)});
    }

    bool readNumber(const PlyProperty& property) {
        const std::optional<double> value = m_numbers.next(property.type);
        if (!value)
            return refuseHere();
        if (property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z')
            m_point[property.name[0] - 'x'] = *value;
        return true;
    }

    bool readList(const PlyElement& element, const PlyProperty& property) {
        const bool isFace =
            element.name == "face" && (property.name == "vertex_indices" || property.name == "vertex_index");
        const std::optional<double> count = m_numbers.next(*property.countType);
        if (!count || !(*count >= 0))
            return refuseHere();
        for (double i = 0; i < *count; ++i) {
            const std::optional<double> value = m_numbers.next(property.type);
            if (!value)
                return refuseHere();
            if (isFace && !addCorner(*value))
                return false;
        }
        return !isFace || m_builder.endFace(m_where);
    }

    bool addCorner(double value) {
        if (value == std::floor(value) && std::abs(value) < 1e15)
            return m_builder.addCorner(static_cast<long long>(value), m_where);
        return refuseHere();
    }

    const PlyHeader& m_header;
    PlyNumbers m_numbers;
    SoupBuilder m_builder;
    std::string m_where;
    Eigen::Vector3d m_point;
};

} // namespace

bool beginsLikePly(std::string_view bytes) {
    return bytes.starts_with("ply\n") || bytes.starts_with("ply\r") || bytes.starts_with("ply ");
}

Result<ReadMesh> readPly(std::string_view bytes, const std::string& name) {
    if (!beginsLikePly(bytes))
        return failure(ErrorCode::BadInput,
                       MW_TEXT("exchange", "{0} is not a PLY file: it does not begin with “ply”."), {name});
    const Result<PlyHeader> header = readPlyHeader(bytes, name);
    return header ? PlyReader(*header, name).read() : std::unexpected(header.error());
}

} // namespace moldwright
