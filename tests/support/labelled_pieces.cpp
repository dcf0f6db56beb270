// SPDX-License-Identifier: AGPL-3.0-or-later
#include "support/labelled_pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace moldwright::test {

namespace {

/// A corner of a face begins the side that runs from it to the next corner.
using Side = std::pair<int, int>; ///< face, corner

/// For each side of each face, the side of the neighbour across it.
std::vector<Side> oppositeSides(const Triangles& F) {
    std::vector<std::array<int, 4>> sorted; // lower point, higher point, face, corner
    for (int f = 0; f < F.rows(); ++f)
        for (int k = 0; k < 3; ++k)
            sorted.push_back(
                {std::min(F(f, k), F(f, (k + 1) % 3)), std::max(F(f, k), F(f, (k + 1) % 3)), f, k});
    std::sort(sorted.begin(), sorted.end());
    std::vector<Side> opposite(sorted.size(), {-1, -1});
    for (std::size_t i = 0; i + 1 < sorted.size(); i += 2) {
        const auto& [a, b, f, k] = sorted[i];
        const auto& [c, d, g, l] = sorted[i + 1];
        opposite[static_cast<std::size_t>(3 * f + k)] = {g, l};
        opposite[static_cast<std::size_t>(3 * g + l)] = {f, k};
    }
    return opposite;
}

class Judge {
public:
    Judge(const IndexedMesh& mesh, const std::vector<std::uint8_t>& labels)
        : m_mesh(mesh), m_labels(labels), m_opposite(oppositeSides(mesh.F)), m_pieceOf(labels.size(), -1),
          m_walked(3 * labels.size(), 0) {}

    std::vector<LabelledPiece> pieces() {
        std::vector<LabelledPiece> found;
        for (int f = 0; f < m_mesh.faceCount(); ++f)
            if (m_pieceOf[static_cast<std::size_t>(f)] < 0)
                found.push_back(piece(f, static_cast<int>(found.size())));
        return found;
    }

private:
    [[nodiscard]] Side across(const Side& s) const {
        return m_opposite[static_cast<std::size_t>(3 * s.first + s.second)];
    }
    [[nodiscard]] std::uint8_t label(int f) const { return m_labels[static_cast<std::size_t>(f)]; }
    [[nodiscard]] bool border(const Side& s) const { return label(across(s).first) != label(s.first); }

    LabelledPiece piece(int seed, int number) {
        LabelledPiece result;
        result.side = label(seed);
        std::vector<int> faces{seed};
        m_pieceOf[static_cast<std::size_t>(seed)] = number;
        int sides = 0;
        int borders = 0;
        std::vector<std::vector<Eigen::Vector2d>> walks;
        for (std::size_t i = 0; i < faces.size(); ++i)
            for (int k = 0; k < 3; ++k) {
                result.box.extend(m_mesh.corner(faces[i], k));
                ++sides;
                const Side s{faces[i], k};
                if (border(s)) {
                    ++borders;
                    continue;
                }
                int& other = m_pieceOf[static_cast<std::size_t>(across(s).first)];
                if (other < 0) {
                    other = number;
                    faces.push_back(across(s).first);
                }
            }
        for (const int f : faces)
            for (int k = 0; k < 3; ++k)
                if (border({f, k}) && !m_walked[static_cast<std::size_t>(3 * f + k)])
                    walks.push_back(walk({f, k}, result.side));
        result.faces = static_cast<int>(faces.size());
        result.euler = fans(faces) - (sides + borders) / 2 + result.faces;
        judge(walks, result);
        return result;
    }

    /// Points of the piece, one for each fan of faces: where the piece only touches itself it counts twice.
    int fans(const std::vector<int>& faces) const {
        std::vector<char> counted(m_walked.size(), 0);
        int count = 0;
        for (const int f : faces)
            for (int k = 0; k < 3; ++k) {
                if (counted[static_cast<std::size_t>(3 * f + k)])
                    continue;
                ++count;
                // Back to the fan's first face, or once round; then forward through the fan.
                Side s{f, k};
                const Side start = s;
                while (!border(s) && (s = nextCorner(across(s))) != start) {
                }
                const Side first = s;
                do {
                    counted[static_cast<std::size_t>(3 * s.first + s.second)] = 1;
                    const Side in{s.first, (s.second + 2) % 3};
                    if (border(in))
                        break;
                    s = across(in);
                } while (s != first);
            }
        return count;
    }

    static Side nextCorner(const Side& s) { return {s.first, (s.second + 1) % 3}; }

    /// The border side that follows, turning about the point between them through the piece's faces.
    Side next(Side s) const {
        s = nextCorner(s);
        while (!border(s))
            s = nextCorner(across(s));
        return s;
    }

    std::vector<Eigen::Vector2d> walk(const Side& start, int side) {
        std::vector<Eigen::Vector2d> points;
        Side s = start;
        do {
            m_walked[static_cast<std::size_t>(3 * s.first + s.second)] = 1;
            const Eigen::Vector3d x = m_mesh.corner(s.first, s.second);
            points.emplace_back(side == 1 ? x.x() : -x.x(), x.y());
            s = next(s);
        } while (s != start);
        return points;
    }

    static double angle(const Eigen::Vector2d& u, const Eigen::Vector2d& v) {
        return std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v));
    }

    static int turning(const std::vector<Eigen::Vector2d>& walk) {
        double sum = 0;
        const std::size_t n = walk.size();
        for (std::size_t i = 0; i < n; ++i)
            sum += angle(walk[(i + 1) % n] - walk[i], walk[(i + 2) % n] - walk[(i + 1) % n]);
        return static_cast<int>(std::lround(sum / (2 * std::numbers::pi)));
    }

    static int winding(const std::vector<Eigen::Vector2d>& walk, const Eigen::Vector2d& p) {
        double sum = 0;
        for (std::size_t i = 0; i < walk.size(); ++i)
            sum += angle(walk[i] - p, walk[(i + 1) % walk.size()] - p);
        return static_cast<int>(std::lround(sum / (2 * std::numbers::pi)));
    }

    static void judge(const std::vector<std::vector<Eigen::Vector2d>>& walks, LabelledPiece& piece) {
        for (const auto& walk : walks)
            piece.turns.push_back(turning(walk));
        if (std::count(piece.turns.begin(), piece.turns.end(), 1) != 1)
            return;
        const auto rim = static_cast<std::size_t>(std::find(piece.turns.begin(), piece.turns.end(), 1) -
                                                  piece.turns.begin());
        for (std::size_t w = 0; w < walks.size(); ++w)
            piece.wound += w != rim && winding(walks[rim], walks[w].front()) == 1 ? 1 : 0;
    }

    const IndexedMesh& m_mesh;
    const std::vector<std::uint8_t>& m_labels;
    std::vector<Side> m_opposite;
    std::vector<int> m_pieceOf;
    std::vector<char> m_walked;
};

} // namespace

PieceVerdict LabelledPiece::verdict() const {
    if (turns.empty())
        return PieceVerdict::Closed;
    if (genus() > 0)
        return PieceVerdict::Handle;
    const auto outer = std::count_if(turns.begin(), turns.end(), [](int t) { return t > 0; });
    if (outer == 0)
        return PieceVerdict::Pocket;
    const bool nested = outer == 1 && wound == static_cast<int>(turns.size()) - 1;
    return nested ? PieceVerdict::Free : PieceVerdict::Arch;
}

std::vector<LabelledPiece> labelledPieces(const IndexedMesh& mesh, const std::vector<std::uint8_t>& labels) {
    return Judge(mesh, labels).pieces();
}

} // namespace moldwright::test
