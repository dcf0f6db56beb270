// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "exchange/mesh_file.h"
#include "exchange/polygon_soup.h"
#include "exchange/text_lines.h"

#include <optional>
#include <string>

namespace moldwright {

/// Gathers what a reader finds, element by element, and refuses what no mesh can hold: numbers that are not
/// finite, faces of fewer than three corners, corners that are no points. `where` says the place in the file,
/// as in "line 12" or "face 7". Every refusal is kept by the builder: a reader stops when failed().
class SoupBuilder {
public:
    explicit SoupBuilder(std::string name) : m_name(std::move(name)) {}

    /// Adds a point from the next three words of a line.
    bool addPoint(std::string_view line, const std::string& where);
    bool addPoint(const Eigen::Vector3d& point, const std::string& where);

    /// Adds a corner, an index from 0, to the face being read. Whether it is a point is judged by finish():
    /// some files list their faces first.
    bool addCorner(long long index, const std::string& where);
    bool endFace(const std::string& where);

    /// Keeps a refusal; its arguments are the file's name, then `arguments`. Always false.
    bool refuse(std::string text, std::vector<std::string> arguments = {});
    void note(std::string text, std::vector<std::string> arguments = {});

    [[nodiscard]] bool failed() const { return m_error.has_value(); }
    [[nodiscard]] int pointCount() const { return static_cast<int>(m_soup.points.size()); }
    [[nodiscard]] int faceCount() const { return m_soup.polygonCount(); }

    /// The mesh, or why there is none.
    [[nodiscard]] Result<ReadMesh> finish() &&;

private:
    std::string m_name;
    PolygonSoup m_soup;
    std::vector<Message> m_notes;
    std::optional<Error> m_error;
    int m_highest = -1; ///< corner index seen so far, and where
    std::string m_highestWhere;
};

} // namespace moldwright
