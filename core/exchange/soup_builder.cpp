// SPDX-License-Identifier: AGPL-3.0-or-later
#include "exchange/soup_builder.h"

#include <limits>

namespace moldwright {

bool SoupBuilder::refuse(std::string text, std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), m_name);
    m_error = Error{ErrorCode::BadInput, {std::move(text), std::move(arguments)}, {}, {}};
    return false;
}

void SoupBuilder::note(std::string text, std::vector<std::string> arguments) {
    m_notes.push_back({std::move(text), std::move(arguments)});
}

bool SoupBuilder::addPoint(std::string_view line, const std::string& where) {
    Eigen::Vector3d point;
    for (double& coordinate : point) {
        const std::string_view word = takeWord(line);
        const std::optional<double> value = realNumber(word);
        if (word.empty())
            return refuse(
                MW_TEXT("exchange", "{0}, {1}: a point needs three numbers, but the line ends early."),
                {where});
        if (!value)
            return refuse(MW_TEXT("exchange", "{0}, {1}: a point needs three finite numbers, but here stands "
                                              "“{2}”."),
                          {where, shown(word)});
        coordinate = *value;
    }
    return addPoint(point, where);
}

bool SoupBuilder::addPoint(const Eigen::Vector3d& point, const std::string& where) {
    if (!point.allFinite())
        return refuse(MW_TEXT("exchange", "{0}, {1}: a coordinate is not a finite number."), {where});
    m_soup.points.push_back(point);
    return true;
}

bool SoupBuilder::addCorner(long long index, const std::string& where) {
    if (index < 0 || index > std::numeric_limits<int>::max())
        return refuse(MW_TEXT("exchange", "{0}, {1}: a face uses point {2}, which does not exist."),
                      {where, std::to_string(index)});
    if (index > m_highest) {
        m_highest = static_cast<int>(index);
        m_highestWhere = where;
    }
    m_soup.corners.push_back(static_cast<int>(index));
    return true;
}

bool SoupBuilder::endFace(const std::string& where) {
    const auto corners = static_cast<int>(m_soup.corners.size()) - m_soup.firstCorner.back();
    if (corners < 3 || corners > mostCorners)
        return refuse(MW_TEXT("exchange", "{0}, {1}: a face has {2} corners; 3 to {3} are possible."),
                      {where, std::to_string(corners), std::to_string(mostCorners)});
    m_soup.endPolygon();
    return true;
}

Result<ReadMesh> SoupBuilder::finish() && {
    if (!failed() && faceCount() == 0)
        refuse(pointCount() == 0 ? MW_TEXT("exchange", "{0} holds no triangles.")
                                 : MW_TEXT("exchange", "{0} holds {1} points but no faces."),
               {std::to_string(pointCount())});
    if (!failed() && m_highest >= pointCount())
        refuse(
            MW_TEXT("exchange", "{0}, {1}: a face uses point {2}, counted from 0, but there are only {3}."),
            {m_highestWhere, std::to_string(m_highest), std::to_string(pointCount())});
    if (m_error)
        return std::unexpected(std::move(*m_error));
    return ReadMesh{triangulated(m_soup), std::move(m_notes)};
}

} // namespace moldwright
