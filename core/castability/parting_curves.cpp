// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/parting_curves.h"

#include "base/stop_point.h"
#include "castability/exact_predicates.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace moldwright {

namespace {

using Eigen::Vector3d;

struct Segment {
    int from = 0;
    int to = 0;
};

/// The curves as seen looking against m_d; all answers exact.
class View {
public:
    View(const Points& V, const Vector3d& d) : m_V(V), m_d(d) {}

    [[nodiscard]] int turn(int a, int b, int c) const { return turnAlong(point(a), point(b), point(c), m_d); }
    [[nodiscard]] int compare(int p, int q, int axis) const {
        return compareAlong(point(p), point(q), m_d, axis);
    }
    /// Left to right, then bottom to top: +1 when p comes before q, −1 after, 0 when their images are one.
    [[nodiscard]] int order(int p, int q) const {
        const int first = compare(p, q, 0);
        return first != 0 ? first : compare(p, q, 1);
    }
    [[nodiscard]] Eigen::Vector2d position(int p) const { return positionAlong(point(p), m_d); }

    /// p, known to lie on the line of ab, lies between a and b or on one of them.
    [[nodiscard]] bool between(int p, int a, int b) const { return order(a, p) * order(p, b) >= 0; }

    /// The images of ab and cd, without a shared vertex, have a point in common.
    [[nodiscard]] bool meet(Segment s, Segment t) const {
        const int c = turn(s.from, s.to, t.from);
        const int e = turn(s.from, s.to, t.to);
        const int a = turn(t.from, t.to, s.from);
        const int b = turn(t.from, t.to, s.to);
        if (c * e < 0 && a * b < 0)
            return true;
        return (c == 0 && between(t.from, s.from, s.to)) || (e == 0 && between(t.to, s.from, s.to)) ||
               (a == 0 && between(s.from, t.from, t.to)) || (b == 0 && between(s.to, t.from, t.to));
    }

    /// The images of ab and bc have more than b in common.
    [[nodiscard]] bool foldBack(int a, int b, int c) const {
        return turn(a, b, c) == 0 && order(a, b) * order(b, c) <= 0;
    }

private:
    [[nodiscard]] Vector3d point(int v) const { return m_V.row(v).transpose(); }

    const Points& m_V;
    Vector3d m_d;
};

std::vector<Segment> segmentsOf(const std::vector<PartingCurve>& curves) {
    std::vector<Segment> segments;
    for (const PartingCurve& curve : curves)
        for (std::size_t i = 0; i < curve.size(); ++i)
            segments.push_back({curve[i], curve[(i + 1) % curve.size()]});
    return segments;
}

/// Boxes of the segments' images, widened by more than the error of the positions they come from.
std::vector<Eigen::AlignedBox2d> boxesOf(const View& view, const std::vector<Segment>& segments,
                                         double error) {
    std::vector<Eigen::AlignedBox2d> boxes;
    for (const Segment& s : segments) {
        Eigen::AlignedBox2d box(view.position(s.from));
        box.extend(view.position(s.to));
        boxes.emplace_back(box.min().array() - error, box.max().array() + error);
    }
    return boxes;
}

bool clash(const View& view, Segment s, Segment t) {
    if (s.to == t.from && s.from == t.to)
        return true;
    if (s.to == t.from)
        return view.foldBack(s.from, s.to, t.to);
    if (t.to == s.from)
        return view.foldBack(t.from, t.to, s.to);
    return view.meet(s, t);
}

bool imagesSimple(const View& view, const std::vector<Segment>& segments, double error) {
    const std::vector<Eigen::AlignedBox2d> boxes = boxesOf(view, segments, error);
    std::vector<std::size_t> order(segments.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return boxes[i].min().x() < boxes[j].min().x(); });
    std::vector<std::size_t> open;
    for (const std::size_t i : order) {
        stopPointAt(static_cast<std::ptrdiff_t>(i));
        std::erase_if(open, [&](std::size_t j) { return boxes[j].max().x() < boxes[i].min().x(); });
        for (const std::size_t j : open)
            if (boxes[i].intersects(boxes[j]) && clash(view, segments[i], segments[j]))
                return false;
        open.push_back(i);
    }
    return std::none_of(segments.begin(), segments.end(),
                        [&](const Segment& s) { return view.order(s.from, s.to) == 0; });
}

/// +1 when a simple curve runs counter-clockwise: the turn at its leftmost point.
int turningOf(const View& view, const PartingCurve& curve) {
    std::size_t left = 0;
    for (std::size_t i = 1; i < curve.size(); ++i)
        if (view.order(curve[i], curve[left]) > 0)
            left = i;
    const std::size_t n = curve.size();
    return view.turn(curve[(left + n - 1) % n], curve[left], curve[(left + 1) % n]);
}

/// Directed edges of the faces with this label whose ends both touch faces of the other one: few, and all
/// that can be on a parting curve.
std::set<std::pair<int, int>> edgesAtBothSides(const IndexedMesh& cast, const SideLabels& labels, int label) {
    std::vector<std::uint8_t> sides(static_cast<std::size_t>(cast.vertexCount()), 0);
    for (int f = 0; f < cast.faceCount(); ++f) {
        stopPointAt(f);
        for (int k = 0; k < 3; ++k)
            sides[static_cast<std::size_t>(cast.F(f, k))] |= labels[static_cast<std::size_t>(f)];
    }
    std::set<std::pair<int, int>> edges;
    for (int f = 0; f < cast.faceCount(); ++f) {
        stopPointAt(f);
        for (int k = 0; k < 3 && labels[static_cast<std::size_t>(f)] == label; ++k) {
            const int from = cast.F(f, k);
            const int to = cast.F(f, (k + 1) % 3);
            if (sides[static_cast<std::size_t>(from)] == 3 && sides[static_cast<std::size_t>(to)] == 3)
                edges.emplace(from, to);
        }
    }
    return edges;
}

/// Whether v, which is not on the curve, lies inside: parity of the edges to its right.
bool inside(const View& view, int v, const PartingCurve& curve) {
    bool in = false;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const int a = curve[i];
        const int b = curve[(i + 1) % curve.size()];
        const bool aAbove = view.compare(v, a, 1) > 0;
        const bool bAbove = view.compare(v, b, 1) > 0;
        if (aAbove != bAbove && (view.turn(a, b, v) > 0) == bAbove)
            in = !in;
    }
    return in;
}

} // namespace

std::optional<std::vector<PartingCurve>> partingCurves(const IndexedMesh& cast, const SideLabels& labels) {
    std::map<int, int> next;
    const std::set<std::pair<int, int>> second = edgesAtBothSides(cast, labels, 2);
    for (const auto& [from, to] : edgesAtBothSides(cast, labels, 1))
        if (second.contains({to, from}) && !next.emplace(from, to).second)
            return std::nullopt;
    std::vector<PartingCurve> curves;
    while (!next.empty()) {
        PartingCurve& curve = curves.emplace_back();
        for (auto step = next.begin(); step != next.end();) {
            curve.push_back(step->first);
            const int to = step->second;
            next.erase(step);
            step = next.find(to);
        }
    }
    return curves;
}

CurveNesting nestingAlong(const Points& V, const std::vector<PartingCurve>& curves, const Vector3d& d,
                          bool fromBelow) {
    const View view(V, d);
    const double largest = V.size() == 0 ? 0 : V.cwiseAbs().maxCoeff();
    CurveNesting nesting;
    nesting.simple =
        imagesSimple(view, segmentsOf(curves),
                     16 * std::numeric_limits<double>::epsilon() * largest * d.cwiseAbs().maxCoeff());
    if (!nesting.simple)
        return nesting;
    nesting.alternating = true;
    for (const PartingCurve& curve : curves) {
        stopPoint();
        int depth = 0;
        for (const PartingCurve& other : curves)
            depth += &other != &curve && inside(view, curve.front(), other) ? 1 : 0;
        nesting.depth.push_back(depth);
        const int expected = (depth % 2 == 0) != fromBelow ? 1 : -1;
        nesting.alternating = nesting.alternating && turningOf(view, curve) == expected;
    }
    return nesting;
}

} // namespace moldwright
