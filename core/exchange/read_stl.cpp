// SPDX-License-Identifier: AGPL-3.0-or-later
#include "exchange/mesh_readers.h"
#include "exchange/soup_builder.h"
#include "mesh/weld.h"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace moldwright {

namespace {

// A binary STL: 80 bytes for anything, a count, and 50 bytes for each triangle, in little-endian order, as is
// this program's machine: normal, three points, two spare bytes.
static_assert(std::endian::native == std::endian::little);
constexpr std::size_t headerBytes = 84;
constexpr std::size_t triangleBytes = 50;
constexpr std::size_t normalBytes = 12;

std::uint64_t announcedTriangles(std::string_view bytes) {
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + headerBytes - sizeof count, sizeof count);
    return count;
}

bool countMatchesSize(std::string_view bytes) {
    return bytes.size() > headerBytes &&
           bytes.size() == headerBytes + triangleBytes * announcedTriangles(bytes);
}

std::string firstWord(std::string_view bytes) {
    TextLines lines(bytes);
    while (lines.next()) {
        std::string_view line = lines.line();
        if (const std::string_view word = takeWord(line); !word.empty())
            return lowerCase(word);
    }
    return {};
}

/// One triangle as its file holds it.
bool addTriangle(std::string_view record, std::size_t number, SoupBuilder& builder) {
    const std::string where = "triangle " + std::to_string(number + 1);
    std::array<float, 9> xyz;
    std::memcpy(xyz.data(), record.data() + normalBytes, sizeof xyz);
    for (std::size_t k = 0; k < 3; ++k)
        if (!builder.addPoint({xyz[3 * k], xyz[3 * k + 1], xyz[3 * k + 2]}, where) ||
            !builder.addCorner(builder.pointCount() - 1, where))
            return false;
    return builder.endFace(where);
}

void readBinary(std::string_view bytes, SoupBuilder& builder) {
    const std::uint64_t announced = announcedTriangles(bytes);
    const std::string_view data = bytes.substr(headerBytes);
    const std::size_t present = data.size() / triangleBytes;
    if (present != announced) {
        builder.refuse(MW_TEXT("exchange",
                               "{0} announces {1} triangles but holds {2}. It is damaged, or not an "
                               "STL file."),
                       {std::to_string(announced), std::to_string(present)});
        return;
    }
    for (std::size_t t = 0; t < present; ++t)
        if (!addTriangle(data.substr(t * triangleBytes, triangleBytes), t, builder))
            return;
    if (const std::size_t spare = data.size() - present * triangleBytes; spare > 0)
        builder.note(MW_TEXT("exchange", "{0} spare bytes at the end were ignored."),
                     {std::to_string(spare)});
}

/// The text form. Only facets and their vertices matter; stored normals may be anything.
class TextStl {
public:
    TextStl(std::string_view bytes, SoupBuilder& builder) : m_lines(bytes), m_builder(builder) {}

    void read() {
        while (!m_builder.failed() && m_lines.next()) {
            std::string_view line = m_lines.line();
            const std::string keyword = lowerCase(takeWord(line));
            if (keyword == "facet")
                beginFace();
            else if (keyword == "vertex")
                addCorner(line);
            else if (keyword == "endfacet")
                endFace();
        }
        if (!m_builder.failed() && m_inFace)
            refuseUnfinished();
    }

private:
    [[nodiscard]] std::string where() const { return "line " + std::to_string(m_lines.number()); }

    void beginFace() {
        if (m_inFace)
            refuseUnfinished();
        m_inFace = true;
    }

    void addCorner(std::string_view line) {
        if (!m_inFace)
            refuseUnfinished();
        else if (m_builder.addPoint(line, where()))
            m_builder.addCorner(m_builder.pointCount() - 1, where());
    }

    void endFace() {
        m_builder.endFace(where());
        m_inFace = false;
    }

    void refuseUnfinished() {
        m_builder.refuse(MW_TEXT("exchange", "{0}, {1}: a facet ends too early. The file may be cut off."),
                         {where()});
    }

    TextLines m_lines;
    SoupBuilder& m_builder;
    bool m_inFace = false;
};

} // namespace

bool beginsLikeStl(std::string_view bytes) {
    return countMatchesSize(bytes) || firstWord(bytes.substr(0, 4096)) == "solid";
}

Result<ReadMesh> readStl(std::string_view bytes, const std::string& name) {
    SoupBuilder builder(name);
    // Many binary files begin with "solid" too, so the size decides first.
    const bool text = !countMatchesSize(bytes) && looksLikeText(bytes) && firstWord(bytes) == "solid";
    if (text)
        TextStl(bytes, builder).read();
    else if (looksLikeText(bytes))
        builder.refuse(
            MW_TEXT("exchange", "{0} is not an STL file: it is text that does not begin with “solid”."));
    else if (bytes.size() < headerBytes)
        builder.refuse(MW_TEXT("exchange", "{0} is {1} bytes long, too short for an STL file."),
                       {std::to_string(bytes.size())});
    else
        readBinary(bytes, builder);
    Result<ReadMesh> read = std::move(builder).finish();
    if (read)
        read->mesh = weldEqualPoints(read->mesh).mesh;
    return read;
}

} // namespace moldwright
