// SPDX-License-Identifier: AGPL-3.0-or-later
#include "pins/simplify.h"

#include "base/parallel.h"
#include "pins/collapsing_axis.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace moldwright {

namespace {

constexpr int kFewBalls = 50; ///< from here on ends and loops are kept
constexpr std::size_t kGrain = 1024;
constexpr int kAskEvery = 256; ///< collapses between questions whether to stop

/// An edge and its cost when its balls had these ages. Small: what the queue costs is memory.
struct Entry {
    float cost;
    int u, v;
    unsigned age; ///< both balls' together

    bool operator>(const Entry& o) const {
        if (cost != o.cost)
            return cost > o.cost;
        return age != o.age ? age > o.age : std::pair(u, v) > std::pair(o.u, o.v);
    }
};

Entry entryOf(const CollapsingAxis& axis, int u, int v) {
    return {static_cast<float>(axis.collapseOf(u, v).cost), std::min(u, v), std::max(u, v),
            axis.age(u) + axis.age(v)};
}

/// The edges by cost. Collapses leave many entries behind that have aged; they are thrown out together,
/// whenever the queue has doubled: taken one by one from the top they would cost more than all else.
class Queue {
public:
    Queue(const CollapsingAxis& axis, std::vector<Entry> entries) : m_axis(axis), m_heap(std::move(entries)) {
        std::make_heap(m_heap.begin(), m_heap.end(), std::greater<>());
        m_limit = 2 * m_heap.size();
    }

    void push(const Entry& entry) {
        if (m_heap.size() >= m_limit) {
            std::erase_if(m_heap, [&](const Entry& e) { return aged(e); });
            std::make_heap(m_heap.begin(), m_heap.end(), std::greater<>());
            m_limit = 2 * m_heap.size() + kGrain;
        }
        m_heap.push_back(entry);
        std::push_heap(m_heap.begin(), m_heap.end(), std::greater<>());
    }

    /// The cheapest entry that has not aged; none when all have gone.
    std::optional<Entry> pop() {
        while (!m_heap.empty()) {
            std::pop_heap(m_heap.begin(), m_heap.end(), std::greater<>());
            const Entry entry = m_heap.back();
            m_heap.pop_back();
            if (!aged(entry))
                return entry;
        }
        return std::nullopt;
    }

private:
    [[nodiscard]] bool aged(const Entry& e) const {
        return m_axis.gone(e.u) || m_axis.gone(e.v) || m_axis.age(e.u) + m_axis.age(e.v) != e.age;
    }

    const CollapsingAxis& m_axis;
    std::vector<Entry> m_heap;
    std::size_t m_limit = 0;
};

/// Down to `count` balls, by cost alone.
void collapseTo(int count, CollapsingAxis& axis, const std::vector<std::array<int, 2>>& edges,
                const Task& task) {
    std::vector<Entry> first(edges.size());
    parallelFor(edges.size(), kGrain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t e = begin; e < end; ++e)
            first[e] = entryOf(axis, edges[e][0], edges[e][1]);
    });
    Queue queue(axis, std::move(first));
    const int all = axis.ballCount();
    while (axis.ballCount() > count) {
        const std::optional<Entry> next = queue.pop();
        if (!next)
            break;
        const int merged = axis.collapse(next->u, next->v, axis.collapseOf(next->u, next->v).ball);
        for (const int w : axis.neighbours(merged))
            queue.push(entryOf(axis, merged, w));
        if (const int done = all - axis.ballCount(); done % kAskEvery == 0) {
            if (task.stopped())
                return;
            task.progress(static_cast<double>(done) / (all - count), "pins");
        }
    }
}

/// The cheapest collapse that keeps ends and loops.
std::optional<Entry> cheapestKeeping(const CollapsingAxis& axis) {
    std::optional<Entry> best;
    for (int u = 0; u < axis.numbers(); ++u)
        for (const int v : axis.neighbours(u)) {
            if (u > v || axis.losesEndOrLoop(u, v))
                continue;
            const Entry entry = entryOf(axis, u, v);
            if (!best || *best > entry)
                best = entry;
        }
    return best;
}

} // namespace

MedialMesh simplify(const MedialMesh& axis, int count, const Task& task) {
    CollapsingAxis collapsing(axis);
    collapseTo(std::max(kFewBalls, count + count / 4), collapsing, axis.edges, task);
    while (collapsing.ballCount() > count && !task.stopped()) {
        const std::optional<Entry> next = cheapestKeeping(collapsing);
        if (!next)
            break;
        collapsing.collapse(next->u, next->v, collapsing.collapseOf(next->u, next->v).ball);
    }
    return collapsing.axis();
}

} // namespace moldwright
