// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/history.h"

#include <set>

namespace moldwright {

namespace {

std::size_t bytesOf(const IndexedMesh& mesh) {
    return sizeof(double) * static_cast<std::size_t>(mesh.V.size()) +
           sizeof(int) * static_cast<std::size_t>(mesh.F.size());
}

} // namespace

void History::push(Step step) {
    m_steps.resize(m_done);
    if (m_saved > static_cast<std::ptrdiff_t>(m_done))
        m_saved = -1;
    const bool merges =
        !step.mergeKey.isEmpty() && m_done > 0 && !atSaved() && m_steps.back().mergeKey == step.mergeKey;
    if (merges) {
        m_steps.back().words = std::move(step.words);
        m_steps.back().after = std::move(step.after);
        return;
    }
    m_steps.push_back(std::move(step));
    ++m_done;
    while (m_done > 1 && bytes() > m_mostBytes) {
        m_steps.erase(m_steps.begin());
        --m_done;
        --m_saved;
    }
}

void History::clear() {
    m_steps.clear();
    m_done = 0;
    m_saved = 0;
}

std::size_t History::bytes() const {
    // What several steps share is held once.
    std::set<const void*> seen;
    std::size_t sum = 0;
    const auto count = [&](const SharedMesh& mesh) {
        if (mesh && seen.insert(mesh.get()).second)
            sum += bytesOf(*mesh);
    };
    const auto countVariant = [&](const Variant& variant) {
        for (const ImportantRegion& region : variant.importance)
            sum += region.faces.size() * (sizeof(int) + sizeof(double));
        for (const TrayPart& part : variant.furtherParts)
            if (seen.insert(part.cast.get()).second) {
                count(part.cast->mesh);
                sum += part.cast->labels.size();
            }
        if (!variant.cast || !seen.insert(variant.cast.get()).second)
            return;
        count(variant.cast->mesh);
        sum += variant.cast->labels.size() +
               sizeof(double) * static_cast<std::size_t>(variant.cast->before.size());
    };
    for (const Step& step : m_steps)
        for (const Project* project : {&step.before, &step.after}) {
            sum += sizeof(Project) + project->others.size() * sizeof(Variant);
            count(project->source);
            count(project->part);
            countVariant(*project);
            for (const Variant& other : project->others)
                countVariant(other);
        }
    return sum;
}

} // namespace moldwright
