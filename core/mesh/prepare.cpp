// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/check.h"

#include "mesh/edge_table.h"
#include "mesh/measures.h"
#include "mesh/orient.h"
#include "mesh/refusal.h"
#include "mesh/weld.h"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

namespace moldwright {

namespace {

// Of the diagonal: what jitter or rounding to text leaves between corners that were one point.
constexpr double nearDistance = 1e-6;

// Beyond these no unit of length makes a part of the numbers, and products of six of them leave the doubles.
constexpr double smallestDiagonal = 1e-40;
constexpr double largestDiagonal = 1e40;

/// Mends a copy of a mesh step by step and remembers which given face each of its faces was.
class Preparation {
public:
    explicit Preparation(const IndexedMesh& given) : m_mesh(given), m_origin(allFaces(given)) {}

    void weldEqual() {
        WeldedMesh welded = weldEqualPoints(withoutUnusedPoints(m_mesh).mesh);
        if (welded.merged > 0)
            say(MW_TEXT("mesh", "{0} equal points were welded."), welded.merged);
        m_mesh = std::move(welded.mesh);
    }

    /// Welding points and rounding numbers can make a face use a point twice.
    void dropCollapsedFaces() {
        const auto before = m_origin.size();
        keepFaces([this](int f) { return !usesAPointTwice(m_mesh, f); });
        if (const auto dropped = before - m_origin.size(); dropped > 0)
            say(MW_TEXT("mesh", "{0} faces that used a point twice were removed."),
                static_cast<int>(dropped));
    }

    /// Repeated faces are removed where edges are shared by more than two faces: all but one of each, or all
    /// of them where only that closes the surface, as between two boxes that were built wall to wall.
    void dropRepeatedFaces() {
        if (EdgeTable(m_mesh.F).closedManifold())
            return;
        const std::vector<int> first = firstOfEqualFaces();
        std::vector<char> repeated(first.size(), 0);
        for (std::size_t f = 0; f < first.size(); ++f)
            if (first[f] != static_cast<int>(f))
                repeated[f] = repeated[static_cast<std::size_t>(first[f])] = 1;
        if (std::count(repeated.begin(), repeated.end(), 1) == 0)
            return;
        Preparation without = *this;
        without.keepFaces([&](int f) { return !repeated[static_cast<std::size_t>(f)]; });
        const auto before = m_origin.size();
        keepFaces([&](int f) { return first[static_cast<std::size_t>(f)] == f; });
        if (!EdgeTable(m_mesh.F).closedManifold() && EdgeTable(without.m_mesh.F).closedManifold() &&
            without.m_mesh.faceCount() > 0)
            *this = std::move(without);
        say(MW_TEXT("mesh", "{0} repeated faces were removed."), static_cast<int>(before - m_origin.size()));
    }

    /// Keeps the welding of near points only if it makes the surface whole.
    void weldNearIfThatCloses() {
        if (EdgeTable(m_mesh.F).closedManifold())
            return;
        Preparation trial = *this;
        WeldedMesh welded = weldNearPoints(m_mesh, nearDistance * diagonal(m_mesh));
        trial.m_mesh = std::move(welded.mesh);
        trial.say(MW_TEXT("mesh", "{0} points within a millionth of the size of each other were welded."),
                  welded.merged);
        trial.dropCollapsedFaces();
        trial.dropRepeatedFaces();
        if (welded.merged > 0 && EdgeTable(trial.m_mesh.F).closedManifold())
            *this = std::move(trial);
    }

    void dropUnusedPoints() { m_mesh = withoutUnusedPoints(m_mesh).mesh; }

    /// The faces that contradict each other, if the surface has one side only.
    std::vector<int> orient() {
        if (!EdgeTable(m_mesh.F).closedManifold())
            return {};
        const Orientation done = orientOutward(m_mesh);
        if (done.turned.size() == m_origin.size())
            m_repairs.push_back({MW_TEXT("mesh", "The surface was inside out and was turned."), {}});
        else if (!done.turned.empty())
            say(MW_TEXT("mesh", "{0} faces looked inward and were turned."),
                static_cast<int>(done.turned.size()));
        return done.contradiction;
    }

    [[nodiscard]] const IndexedMesh& mesh() const { return m_mesh; }

    [[nodiscard]] std::vector<Message>& repairs() { return m_repairs; }

    /// `error`, with the faces it names as they were given.
    [[nodiscard]] Error asGiven(Error error) const {
        for (int& f : error.faces)
            f = m_origin[static_cast<std::size_t>(f)];
        return error;
    }

private:
    static std::vector<int> allFaces(const IndexedMesh& mesh) {
        std::vector<int> faces(static_cast<std::size_t>(mesh.faceCount()));
        for (std::size_t f = 0; f < faces.size(); ++f)
            faces[f] = static_cast<int>(f);
        return faces;
    }

    void say(std::string text, int count) { m_repairs.push_back({std::move(text), {std::to_string(count)}}); }

    void keepFaces(const auto& keep) {
        std::vector<int> kept;
        for (int f = 0; f < m_mesh.faceCount(); ++f)
            if (keep(f))
                kept.push_back(f);
        std::vector<int> origin;
        for (const int f : kept)
            origin.push_back(m_origin[static_cast<std::size_t>(f)]);
        m_mesh.F = m_mesh.F(kept, Eigen::all).eval();
        m_origin = std::move(origin);
    }

    /// For each face the first one with the same three points, in whatever order.
    [[nodiscard]] std::vector<int> firstOfEqualFaces() const {
        std::map<std::array<int, 3>, int> seen;
        std::vector<int> first;
        for (int f = 0; f < m_mesh.faceCount(); ++f) {
            std::array<int, 3> points = {m_mesh.F(f, 0), m_mesh.F(f, 1), m_mesh.F(f, 2)};
            std::sort(points.begin(), points.end());
            first.push_back(seen.try_emplace(points, f).first->second);
        }
        return first;
    }

    IndexedMesh m_mesh;
    std::vector<int> m_origin;
    std::vector<Message> m_repairs;
};

Error refused(std::string text, std::vector<std::string> arguments) {
    return {ErrorCode::BadInput, {std::move(text), std::move(arguments)}, {}, {}};
}

/// What can be said before anything is mended, if that is the end of it.
std::optional<Error> sizeRefusal(const IndexedMesh& mesh, const std::string& name) {
    if (mesh.faceCount() == 0)
        return refused(MW_TEXT("mesh", "{0} holds no faces."), {name});
    if (!mesh.V.allFinite())
        return refused(MW_TEXT("mesh", "{0} holds a coordinate that is not a finite number."), {name});
    const double size = diagonal(mesh);
    if (size >= smallestDiagonal && size <= largestDiagonal)
        return std::nullopt;
    return refused(
        MW_TEXT("mesh", "{0} measures {1} from corner to corner. No unit of length makes a part of that."),
        {name, readable(size)});
}

std::optional<Error> collapseRefusal(int given, int left, const std::string& name) {
    if (2 * left >= given)
        return std::nullopt;
    return refused(
        MW_TEXT("mesh", "{0} of the {1} faces of {2} shrink to a line or a point. Its numbers have too few "
                        "digits for its size or its place: write it with more digits, or nearer to the "
                        "origin."),
        {std::to_string(given - left), std::to_string(given), name});
}

} // namespace

Examination examine(const IndexedMesh& mesh, const std::string& name) {
    if (std::optional<Error> reason = sizeRefusal(mesh, name))
        return {mesh, {}, {}, {}, {std::move(*reason)}};
    Preparation preparation(mesh);
    preparation.weldEqual();
    preparation.dropCollapsedFaces();
    if (std::optional<Error> reason = collapseRefusal(mesh.faceCount(), preparation.mesh().faceCount(), name))
        return {mesh, {}, {}, {}, {std::move(*reason)}};
    preparation.dropRepeatedFaces();
    preparation.weldNearIfThatCloses();
    const std::vector<int> oneSided = preparation.orient();
    preparation.dropUnusedPoints();

    Examination result;
    result.mesh = preparation.mesh();
    result.diagnosis = diagnose(result.mesh);
    // Of a one-sided surface neither inside nor volume mean anything.
    std::vector<Error> faults = oneSided.empty() ? refusals(result.mesh, result.diagnosis, name)
                                                 : std::vector{oneSidedRefusal(result.mesh, oneSided, name)};
    for (Error& fault : faults)
        result.faults.push_back(preparation.asGiven(std::move(fault)));
    result.repairs = std::move(preparation.repairs());
    if (result.diagnosis.closed && result.diagnosis.components > 1)
        result.notes.push_back({MW_TEXT("mesh", "{0} consists of {1} separate solids."),
                                {name, std::to_string(result.diagnosis.components)}});
    return result;
}

Result<PreparedMesh> prepare(const IndexedMesh& mesh, const std::string& name) {
    Examination done = examine(mesh, name);
    if (!done.faults.empty())
        return std::unexpected(std::move(done.faults.front()));
    return PreparedMesh{std::move(done.mesh), std::move(done.repairs), std::move(done.notes)};
}

} // namespace moldwright
