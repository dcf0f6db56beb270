// SPDX-License-Identifier: AGPL-3.0-or-later
#include "exchange/mesh_readers.h"
#include "exchange/soup_builder.h"

#include <array>

namespace moldwright {

namespace {

/// Reads line by line, since what follows a point or a face on its line (colours, normals) has no fixed
/// length; comments and empty lines do not count.
class OffReader {
public:
    OffReader(std::string_view bytes, const std::string& name) : m_lines(bytes), m_builder(name) {}

    Result<ReadMesh> read() {
        if (readCounts() && readPoints() && readFaces())
            noteRest();
        return std::move(m_builder).finish();
    }

private:
    /// The next line that says something, without its comment.
    bool nextLine() {
        while (m_lines.next()) {
            m_line = m_lines.line().substr(0, m_lines.line().find('#'));
            std::string_view rest = m_line;
            if (!takeWord(rest).empty())
                return true;
        }
        return m_builder.refuse(MW_TEXT("exchange",
                                        "{0} ends too early: after {1} of {2} points and {3} of {4} "
                                        "faces."),
                                {std::to_string(m_builder.pointCount()), std::to_string(m_points),
                                 std::to_string(m_builder.faceCount()), std::to_string(m_faces)});
    }

    [[nodiscard]] std::string where() const { return "line " + std::to_string(m_lines.number()); }

    /// Takes [ST][C][N][4][n]OFF off the line; the counts may stand right behind it, and some files have
    /// none.
    bool takeKeyword() {
        std::string_view rest = m_line;
        const std::string_view word = takeWord(rest);
        const std::size_t at = word.find("OFF");
        if (at == std::string_view::npos)
            return true;
        if (word.substr(0, at).find_first_of("4n") != std::string_view::npos)
            return m_builder.refuse(MW_TEXT("exchange", "{0} holds points of other than three dimensions."));
        m_line.remove_prefix(static_cast<std::size_t>(word.data() - m_line.data()) + at + 3);
        rest = m_line;
        const std::string_view next = takeWord(rest);
        if (next == "BINARY")
            return m_builder.refuse(
                MW_TEXT("exchange", "{0} is a binary OFF file; only OFF in text is read."));
        return !next.empty() || nextLine();
    }

    bool readCounts() {
        if (!nextLine() || !takeKeyword())
            return false;
        for (long long* count : {&m_points, &m_faces}) {
            const std::string_view word = takeWord(m_line);
            const std::optional<long long> number = wholeNumber(word);
            if (!number || *number < 0)
                return m_builder.refuse(MW_TEXT("exchange", "{0}, {1}: here should stand how many points and "
                                                            "faces there are, not “{2}”."),
                                        {where(), shown(word)});
            *count = *number;
        }
        return true;
    }

    bool readPoints() {
        for (long long i = 0; i < m_points; ++i)
            if (!nextLine() || !m_builder.addPoint(m_line, where()))
                return false;
        return true;
    }

    bool readFaces() {
        for (long long i = 0; i < m_faces; ++i)
            if (!nextLine() || !readFace())
                return false;
        return true;
    }

    bool readFace() {
        const std::optional<long long> corners = wholeNumber(takeWord(m_line));
        for (long long k = 0; corners && k < *corners; ++k) {
            const std::string_view word = takeWord(m_line);
            const std::optional<long long> index = wholeNumber(word);
            if (!index)
                return m_builder.refuse(MW_TEXT("exchange",
                                                "{0}, {1}: a face of {2} corners needs as many numbers "
                                                "of points. The file may be cut off."),
                                        {where(), std::to_string(*corners)});
            if (!m_builder.addCorner(*index, where()))
                return false;
        }
        return m_builder.endFace(where());
    }

    void noteRest() {
        while (m_lines.next()) {
            std::string_view rest = m_lines.line().substr(0, m_lines.line().find('#'));
            if (!takeWord(rest).empty())
                return m_builder.note(MW_TEXT("exchange", "What follows the last face was ignored."));
        }
    }

    TextLines m_lines;
    std::string_view m_line;
    SoupBuilder m_builder;
    long long m_points = 0;
    long long m_faces = 0;
};

} // namespace

bool beginsLikeOff(std::string_view bytes) {
    constexpr std::size_t sample = 4096;
    TextLines lines(bytes.substr(0, sample));
    while (lines.next()) {
        std::string_view line = lines.line().substr(0, lines.line().find('#'));
        const std::string_view word = takeWord(line);
        if (word.empty())
            continue;
        const std::size_t at = word.find("OFF");
        return at != std::string_view::npos &&
               word.substr(0, at).find_first_not_of("STCN4n") == std::string_view::npos;
    }
    return false;
}

Result<ReadMesh> readOff(std::string_view bytes, const std::string& name) {
    return OffReader(bytes, name).read();
}

} // namespace moldwright
