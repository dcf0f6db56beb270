// SPDX-License-Identifier: AGPL-3.0-or-later
// Importance: what is painted, and how it came through.
#include "window/workbench.h"

#include "mesh/measures.h"
#include "project/edits.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

constexpr double firstBrush = 0.03; ///< of the part's diagonal
constexpr double leastBrush = 0.001;
constexpr double mostBrush = 0.2;

/// To two figures, as one would type it.
double rounded(double mm) {
    const double unit = std::pow(10, std::floor(std::log10(mm)) - 1);
    return unit * std::round(mm / unit);
}

/// The same for the same regions: pieces of one drag become one step.
QString mergeKeyOf(QString key, const std::vector<int>& regions) {
    for (const int region : regions)
        key += QStringLiteral("-%1").arg(region);
    return key;
}

} // namespace

double Workbench::brushRadius() const {
    return project().part
               ? m_brushRadius.value_or(rounded(firstBrush * figures(project().part).box.diagonal().norm()))
               : 1;
}

double Workbench::largestBrush() const {
    return rounded(mostBrush * figures(project().part).box.diagonal().norm());
}

void Workbench::setBrushRadius(double mm) {
    const double size = figures(project().part).box.diagonal().norm();
    m_brushRadius = std::clamp(mm, leastBrush * size, mostBrush * size);
    Q_EMIT changed();
}

void Workbench::setCreaseDegrees(double degrees) {
    m_creaseDegrees = std::clamp(degrees, 1.0, 180.0);
    Q_EMIT changed();
}

QString Workbench::newRegionName() const {
    const auto& regions = m_document.committed().importance;
    for (std::size_t number = regions.size() + 1;; ++number) {
        const QString name = tr("Region %1").arg(number);
        if (std::ranges::count(regions, name.toStdString(), &ImportantRegion::name) == 0)
            return name;
    }
}

Project Workbench::painted(int region, const std::vector<int>& faces, bool erase) const {
    std::vector<ImportantRegion> regions = m_document.committed().importance;
    if (erase) {
        for (int i = 0; i < static_cast<int>(regions.size()); ++i)
            if (region < 0 || region == i)
                regions[static_cast<std::size_t>(i)] = lighter(regions[static_cast<std::size_t>(i)], faces);
    } else if (region < 0) {
        regions.push_back(heavier({newRegionName().toStdString(), {}, {}, 0}, faces));
    } else {
        ImportantRegion& one = regions.at(static_cast<std::size_t>(region));
        one = heavier(one, faces);
    }
    return withImportance(m_document.committed(), std::move(regions));
}

void Workbench::previewStroke(int region, const std::vector<int>& faces, bool erase) {
    m_document.preview(painted(region, faces, erase));
}

int Workbench::stroke(int region, const std::vector<int>& faces, bool erase) {
    const Project after = painted(region, faces, erase);
    m_document.edit(erase ? tr("Erase importance") : tr("Paint importance"), after);
    return region < 0 && !erase ? static_cast<int>(after.importance.size()) - 1 : region;
}

void Workbench::strokeIn(const scene::Lasso& lasso, const ShownSurface& surface, int region, bool erase,
                         const std::function<void(int)>& then) {
    const SharedMesh part = project().part;
    const SharedMesh seen = surface.drawn->mesh;
    const auto before = surface.before;
    m_background.start(tr("Looking which faces are seen"), [=, this](const Task& task) -> Background::Finish {
        std::vector<int> faces = scene::facesIn(lasso, seen, task);
        if (seen != part && !task.stopped())
            faces = FaceOrigins(part, seen, before).onPart(faces);
        return [=, this] {
            if (faces.empty() || project().part != part)
                say(Standing::Info, tr("No face's middle is seen inside the lasso."));
            else
                then(stroke(region, faces, erase));
        };
    });
}

void Workbench::editRegions(const std::vector<int>& numbers, const QString& words, const QString& mergeKey,
                            bool preview, const std::function<void(ImportantRegion&)>& change) {
    std::vector<ImportantRegion> regions = m_document.committed().importance;
    for (const int number : numbers)
        change(regions.at(static_cast<std::size_t>(number)));
    const Project after = withImportance(m_document.committed(), std::move(regions));
    if (preview)
        m_document.preview(after);
    else
        m_document.edit(words, after, mergeKey);
}

void Workbench::renameRegion(int region, const QString& name) {
    editRegions({region}, tr("Rename"), {}, false,
                [&](ImportantRegion& changed) { changed.name = name.toStdString(); });
}

void Workbench::weighRegions(const std::vector<int>& regions, double weight, bool preview) {
    editRegions(regions, regions.size() == 1 ? tr("Change a region's weight") : tr("Change regions' weights"),
                mergeKeyOf(QStringLiteral("region-weight"), regions), preview,
                [&](ImportantRegion& changed) { changed = weighing(std::move(changed), weight); });
}

void Workbench::limitRegions(const std::vector<int>& regions, double keepWithin, bool preview) {
    editRegions(regions, regions.size() == 1 ? tr("Change a region's limit") : tr("Change regions' limits"),
                mergeKeyOf(QStringLiteral("region-limit"), regions), preview,
                [&](ImportantRegion& changed) { changed.keepWithin = std::max(0.0, keepWithin); });
}

void Workbench::removeRegions(const std::vector<int>& numbers) {
    const std::vector<ImportantRegion>& regions = m_document.committed().importance;
    std::vector<ImportantRegion> kept;
    for (int i = 0; i < static_cast<int>(regions.size()); ++i)
        if (std::ranges::find(numbers, i) == numbers.end())
            kept.push_back(regions[static_cast<std::size_t>(i)]);
    const QString words =
        numbers.size() == 1
            ? tr("Remove %1")
                  .arg(QString::fromStdString(regions.at(static_cast<std::size_t>(numbers.front())).name))
            : tr("Remove %1 regions").arg(numbers.size());
    m_document.edit(words, withImportance(m_document.committed(), std::move(kept)));
}

void Workbench::clearImportance() {
    m_document.edit(tr("Remove all regions"), withImportance(m_document.committed(), {}));
}

const RegionMeasure* Workbench::measureOf(int region) const {
    const auto& cast = project().cast;
    const auto at = static_cast<std::size_t>(region);
    return cast && cast->regions.size() == project().importance.size() && at < cast->regions.size()
               ? &cast->regions[at]
               : nullptr;
}

void Workbench::tellOfRegions() {
    for (int i = 0; i < static_cast<int>(project().importance.size()); ++i) {
        const ImportantRegion& region = project().importance[static_cast<std::size_t>(i)];
        const RegionMeasure* measure = measureOf(i);
        if (!measure || region.faces.empty() || region.keepWithin <= 0)
            continue;
        const QString name = QString::fromStdString(region.name);
        const QString moved = QString::number(measure->maxDistance, 'f', 2);
        const QString limit = QString::number(region.keepWithin, 'f', 2);
        if (keepsWithin(region, *measure))
            say(Standing::Done,
                tr("%1 kept its shape within %2 mm: it changed by %3 mm.").arg(name, limit, moved));
        else
            say(Standing::Warning,
                tr("%1 changed its shape by %2 mm, more than the %3 mm allowed. Give it more "
                   "weight, or take another plane.")
                    .arg(name, moved, limit));
    }
}

} // namespace moldwright
