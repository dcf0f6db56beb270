// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/touching_boxes.h"

#include "base/block_sort.h"
#include "base/parallel.h"
#include "base/stop_point.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>

namespace moldwright {

namespace {

using Box = Eigen::AlignedBox3d;

constexpr std::size_t facesALeaf = 4;
constexpr std::size_t leavesABlock = 128;

/// Spreads the lowest ten bits of x to every third bit.
std::uint32_t spread(std::uint32_t x) {
    x = (x | x << 16) & 0x030000FF;
    x = (x | x << 8) & 0x0300F00F;
    x = (x | x << 4) & 0x030C30C3;
    return (x | x << 2) & 0x09249249;
}

/// Place of p along a curve that fills the box and keeps near points near. [Morton 1966]
std::uint32_t placeOnCurve(const Eigen::Vector3d& p, const Box& box) {
    std::uint32_t place = 0;
    for (int k = 0; k < 3; ++k) {
        const double size = box.sizes()[k];
        const double share = size > 0 ? (p[k] - box.min()[k]) / size : 0;
        place |= spread(static_cast<std::uint32_t>(std::clamp(share, 0.0, 1.0) * 1023)) << k;
    }
    return place;
}

/// A complete binary tree of boxes as in a heap: node i has the children 2i and 2i+1, node 1 holds
/// everything; its leaves hold facesALeaf faces each, in the order of the curve.
class BoxTree {
public:
    BoxTree(const IndexedMesh& mesh, const std::vector<int>& faces) {
        Box whole;
        std::vector<Box> boxOf;
        boxOf.reserve(faces.size());
        for (const int f : faces) {
            stopPointAt(f);
            boxOf.emplace_back(mesh.corner(f, 0));
            boxOf.back().extend(mesh.corner(f, 1)).extend(mesh.corner(f, 2));
            whole.extend(boxOf.back());
        }
        std::vector<std::pair<std::uint32_t, std::size_t>> order;
        order.reserve(faces.size());
        for (std::size_t i = 0; i < faces.size(); ++i) {
            stopPointAt(static_cast<std::ptrdiff_t>(i));
            order.emplace_back(placeOnCurve(boxOf[i].center(), whole), i);
        }
        sortInBlocks(order);
        for (const auto& [place, i] : order) {
            stopPointAt(static_cast<std::ptrdiff_t>(i));
            m_faces.push_back(faces[i]);
            m_boxes.push_back(boxOf[i]);
        }
        m_leaves = std::bit_ceil((faces.size() + facesALeaf - 1) / facesALeaf);
        m_nodes.resize(2 * m_leaves);
        for (std::size_t i = 0; i < m_boxes.size(); ++i)
            m_nodes[m_leaves + i / facesALeaf].extend(m_boxes[i]);
        for (std::size_t node = m_leaves - 1; node > 0; --node)
            m_nodes[node] = m_nodes[2 * node].merged(m_nodes[2 * node + 1]);
    }

    /// How many leaves hold faces.
    [[nodiscard]] std::size_t leafCount() const { return (m_faces.size() + facesALeaf - 1) / facesALeaf; }

    /// Calls found(f, g) for each face f of a leaf and every face g later along the curve whose box touches
    /// f's.
    void forLaterFacesTouching(std::size_t leaf, const auto& found) const {
        const Box& own = m_nodes[m_leaves + leaf];
        std::array<std::size_t, 64> waiting = {1};
        for (std::size_t count = 1; count > 0;) {
            const std::size_t node = waiting[--count];
            if (lastLeafBelow(node) < leaf || !m_nodes[node].intersects(own))
                continue;
            if (node < m_leaves) {
                waiting[count++] = 2 * node + 1;
                waiting[count++] = 2 * node;
                continue;
            }
            compare(leaf, node - m_leaves, found);
        }
    }

private:
    [[nodiscard]] std::size_t lastLeafBelow(std::size_t node) const {
        const int levels = std::countl_zero(node) - std::countl_zero(m_leaves);
        return ((node + 1) << levels) - 1 - m_leaves;
    }

    void compare(std::size_t leaf, std::size_t other, const auto& found) const {
        const auto endOf = [&](std::size_t at) { return std::min((at + 1) * facesALeaf, m_faces.size()); };
        for (std::size_t i = leaf * facesALeaf; i < endOf(leaf); ++i)
            for (std::size_t j = std::max(other * facesALeaf, i + 1); j < endOf(other); ++j)
                if (m_boxes[j].intersects(m_boxes[i]))
                    found(m_faces[i], m_faces[j]);
    }

    std::vector<int> m_faces;
    std::vector<Box> m_boxes;
    std::vector<Box> m_nodes;
    std::size_t m_leaves = 0;
};

} // namespace

std::vector<std::pair<int, int>> pairsWithTouchingBoxes(const IndexedMesh& mesh,
                                                        const std::vector<int>& faces,
                                                        const std::function<bool(int, int)>& keep) {
    if (faces.empty())
        return {};
    const BoxTree tree(mesh, faces);
    const std::size_t leaves = tree.leafCount();
    std::vector<std::vector<std::pair<int, int>>> ofBlock((leaves + leavesABlock - 1) / leavesABlock);
    parallelFor(leaves, leavesABlock, [&](std::size_t begin, std::size_t end) {
        auto& pairs = ofBlock[begin / leavesABlock];
        for (std::size_t leaf = begin; leaf < end; ++leaf)
            tree.forLaterFacesTouching(leaf, [&](int f, int g) {
                const std::pair<int, int> pair = std::minmax(f, g);
                if (keep(pair.first, pair.second))
                    pairs.push_back(pair);
            });
    });
    std::vector<std::pair<int, int>> all;
    for (const auto& pairs : ofBlock)
        all.insert(all.end(), pairs.begin(), pairs.end());
    std::sort(all.begin(), all.end());
    return all;
}

} // namespace moldwright
