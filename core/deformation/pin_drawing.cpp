// SPDX-License-Identifier: AGPL-3.0-or-later
#include "deformation/pin_drawing.h"

#include "deformation/contacts.h"
#include "deformation/plane_system.h"

#include <algorithm>
#include <optional>

namespace moldwright {

namespace {

constexpr int kSteps = 24;
constexpr int kIterations = 20;     ///< a step
constexpr int kLastIterations = 60; ///< with all points in the plane
constexpr int kSeenEvery = 4;       ///< iterations
constexpr double kGap = 1.5;        ///< mean edges that are kept between surfaces which come to meet
constexpr double kContact = 1;      ///< of the mean stiffness of a point, that a contact has
constexpr double kAnchor = 0.1; ///< per volume: limbs bend rather than the whole body turning about its pins
constexpr double kSettled = 1e-12; ///< mean square motion, working units

/// The volume of each point's share of its tetrahedra.
Eigen::VectorXd volumesAt(const BodyShape& body) {
    Eigen::VectorXd volumes = Eigen::VectorXd::Zero(body.V.rows());
    for (Eigen::Index t = 0; t < body.T.rows(); ++t) {
        const auto edge = [&](int k) -> Eigen::Vector3d {
            return body.V.row(body.T(t, k)) - body.V.row(body.T(t, 0));
        };
        const double volume = std::abs(edge(1).cross(edge(2)).dot(edge(3))) / 6;
        for (int k = 0; k < 4; ++k)
            volumes[body.T(t, k)] += volume / 4;
    }
    return volumes;
}

class Drawing {
public:
    using Seen = std::function<void(const Positions&)>;

    Drawing(const BodyShape& body, const std::vector<int>& points, const Seen& seen)
        : m_body(body), m_points(points), m_seen(seen), m_elastic(body),
          m_held(static_cast<std::size_t>(body.V.rows()), 0), m_gap(kGap * meanEdge(body)), m_X(body.V) {
        for (const int v : points)
            m_held[static_cast<std::size_t>(v)] = 1;
        m_anchors = kAnchor * volumesAt(body);
        m_contactWeight = kContact * m_elastic.laplacian().diagonal().mean();
        assemble();
    }

    /// The points brought to this share of their heights at rest.
    void step(double share, int iterations, const Task& task) {
        // What is solved holds points at z = 0; `lifted` has the heights that they still have.
        Positions lifted = Positions::Zero(m_X.rows(), 3);
        for (const int v : m_points)
            lifted(v, 2) = share * m_body.V(v, 2);
        const Positions pull = m_matrix.selfadjointView<Eigen::Lower>() * lifted;
        for (int i = 0; i < iterations && !task.stopped(); ++i) {
            m_elastic.fit(m_X, m_rotations);
            Positions B = m_elastic.rightHandSide(m_rotations) + m_system->shift() * (m_X - lifted) - pull +
                          m_anchors.asDiagonal() * m_body.V;
            push(B);
            const Positions next = m_system->solve(B) + lifted;
            const double motion = (next - m_X).squaredNorm() / static_cast<double>(next.rows());
            m_X = next;
            if (motion < kSettled)
                break;
            if (m_seen && i % kSeenEvery == kSeenEvery - 1)
                m_seen(m_X);
        }
        meet();
    }

    [[nodiscard]] const Positions& positions() const { return m_X; }

private:
    /// Contacts of now; those of before stay, or surfaces would fall back into each other.
    void meet() {
        const std::size_t before = m_contacts.size();
        for (const Contact& contact : contactsAt(m_body, m_X, m_gap)) {
            const auto known = std::ranges::find_if(
                m_contacts, [&](const Contact& c) { return c.a == contact.a && c.b == contact.b; });
            if (known == m_contacts.end())
                m_contacts.push_back(contact);
        }
        if (m_contacts.size() > before)
            assemble();
    }

    void assemble() {
        std::vector<Eigen::Triplet<double>> springs;
        for (Eigen::Index v = 0; v < m_anchors.size(); ++v)
            springs.emplace_back(v, v, m_anchors[v]);
        for (const Contact& contact : m_contacts) {
            springs.emplace_back(contact.a, contact.a, m_contactWeight);
            springs.emplace_back(contact.b, contact.b, m_contactWeight);
            springs.emplace_back(std::max(contact.a, contact.b), std::min(contact.a, contact.b),
                                 -m_contactWeight);
        }
        Eigen::SparseMatrix<double> added(m_X.rows(), m_X.rows());
        added.setFromTriplets(springs.begin(), springs.end());
        m_matrix = m_elastic.laplacian() + added;
        m_system.emplace(m_matrix, m_held);
        (void)m_system->factor(m_matrix); // positive definite: a sum of squares, shifted
    }

    /// What contacts add to the right-hand side: points that are far enough apart keep their difference.
    void push(Positions& B) const {
        for (const Contact& contact : m_contacts) {
            Eigen::RowVector3d apart = m_X.row(contact.a) - m_X.row(contact.b);
            apart +=
                std::max(0.0, contact.gap - apart.dot(contact.away.transpose())) * contact.away.transpose();
            B.row(contact.a) += m_contactWeight * apart;
            B.row(contact.b) -= m_contactWeight * apart;
        }
    }

    const BodyShape& m_body;
    const std::vector<int>& m_points;
    const Seen& m_seen;
    ElasticBody m_elastic;
    std::vector<char> m_held;
    double m_gap;
    double m_contactWeight = 0;
    Eigen::VectorXd m_anchors; ///< stiffness that holds each point where it is at rest
    Positions m_X;
    Rotations m_rotations;
    std::vector<Contact> m_contacts;
    Eigen::SparseMatrix<double> m_matrix; ///< of the body and its contacts, lower triangle
    std::optional<PlaneSystem> m_system;
};

} // namespace

Positions drawnIntoPlane(const BodyShape& body, const std::vector<int>& points, const Task& task,
                         const std::function<void(const Positions&)>& seen) {
    Drawing drawing(body, points, seen);
    for (int step = 1; step <= kSteps && !task.stopped(); ++step)
        drawing.step(1 - static_cast<double>(step) / kSteps, kIterations, task);
    drawing.step(0, kLastIterations, task);
    return drawing.positions();
}

} // namespace moldwright
