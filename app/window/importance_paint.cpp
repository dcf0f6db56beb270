// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/importance_paint.h"

#include "design/face_origins.h"
#include "mesh/measures.h"
#include "theme/theme.h"
#include "window/importance_pages.h"
#include "window/presentation.h"
#include "window/workbench.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(ImportancePaint)
};

constexpr int classes = 6; ///< plain, and ×2 to ×32

bool isPart(const Workbench& bench, const ShownSurface& surface) {
    return surface.drawn && surface.drawn->mesh == bench.project().part;
}

/// Of a cast or a frame; null for the part, and while they are not known.
std::shared_ptr<const FaceOrigins> originsOf(const Workbench& bench, const ShownSurface& surface) {
    return surface.drawn && surface.before && !isPart(bench, surface)
               ? bench.origins().of({bench.project().part, surface.drawn->mesh, surface.before})
               : nullptr;
}

/// The regions that are shown.
std::vector<ImportantRegion> shownRegions(const Workbench& bench, const Visibility& visible) {
    std::vector<ImportantRegion> shown;
    const std::vector<ImportantRegion>& regions = bench.project().importance;
    for (int i = 0; i < static_cast<int>(regions.size()); ++i)
        if (visible.importance && visible.shows(regionId(i)))
            shown.push_back(regions[static_cast<std::size_t>(i)]);
    return shown;
}

scene::Rgb colourOf(int weightClass) {
    return weightClass == 0 ? theme().scene.part
                            : scene::importanceColours().at(static_cast<std::size_t>(weightClass - 1));
}

Eigen::Vector3d middleOf(const IndexedMesh& mesh, int f) {
    return (mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3;
}

/// The region's face whose middle lies nearest to the middle of them all.
int middleFace(const ImportantRegion& region, const IndexedMesh& part) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const int f : region.faces)
        sum += middleOf(part, f);
    const Eigen::Vector3d middle = sum / static_cast<double>(region.faces.size());
    return *std::ranges::min_element(region.faces, {},
                                     [&](int f) { return (middleOf(part, f) - middle).squaredNorm(); });
}

} // namespace

FacePaint importancePaint(const Workbench& bench, const ShownSurface& surface, const Visibility& visible) {
    FacePaint paint;
    const auto faces = static_cast<std::size_t>(surface.drawn->mesh->faceCount());
    paint.faces.assign(faces, theme().scene.part);
    const auto origins = originsOf(bench, surface);
    if (origins || isPart(bench, surface)) {
        const std::vector<double> weights =
            faceWeights(shownRegions(bench, visible), bench.project().part->faceCount());
        // Empty while nothing is painted.
        for (std::size_t f = 0; f < faces && !weights.empty(); ++f)
            if (const int source = origins ? origins->faces()[f] : static_cast<int>(f); source >= 0)
                paint.faces[f] = colourOf(scene::importanceClass(weights[static_cast<std::size_t>(source)]));
    }
    if (surface.drawn->standIn)
        paint.standIn.assign(static_cast<std::size_t>(surface.drawn->standIn->mesh->faceCount()),
                             theme().scene.part);
    for (std::size_t f = 0; f < surface.drawn->standInFaces.size(); ++f)
        paint.standIn[f] = paint.faces[static_cast<std::size_t>(surface.drawn->standInFaces[f])];
    return paint;
}

scene::PanelContent importanceLegend(const Workbench& bench, const ShownSurface& surface,
                                     const Visibility& visible) {
    scene::PanelContent legend;
    legend.title = Words::tr("Importance").toStdString();
    if (!isPart(bench, surface) && !originsOf(bench, surface)) {
        const QString why = surface.before ? Words::tr("Looking where the faces come from")
                                           : Words::tr("Not known for this shape.");
        legend.lines.push_back({std::nullopt, {{why.toStdString(), scene::Ink::Secondary}}, {}});
        return legend;
    }
    const IndexedMesh& part = *bench.project().part;
    std::array<double, classes> areas{};
    const std::vector<double> weights = faceWeights(shownRegions(bench, visible), part.faceCount());
    for (std::size_t f = 0; f < weights.size(); ++f)
        if (const int at = scene::importanceClass(weights[f]); at > 0)
            areas[static_cast<std::size_t>(at)] += doubleAreaVector(part, static_cast<int>(f)).norm() / 2;
    areas[0] = bench.figures(bench.project().part).area;
    for (std::size_t at = 1; at < areas.size(); ++at)
        areas[0] -= areas[at];
    const std::array<QString, classes> words = {
        Words::tr("like the rest"), u"×2"_s, u"×4"_s, u"×8"_s, u"×16"_s, Words::tr("×32 or more")};
    for (int at = classes - 1; at >= 0; --at)
        legend.lines.push_back(
            {colourOf(at),
             {{words.at(static_cast<std::size_t>(at)).toStdString()}},
             u"%1 cm²"_s.arg(areas.at(static_cast<std::size_t>(at)) / 100, 0, 'f', 1).toStdString()});
    return legend;
}

std::vector<RegionPlace> regionPlaces(const Workbench& bench, const ShownSurface& surface,
                                      const Visibility& visible) {
    std::vector<RegionPlace> places;
    const auto origins = originsOf(bench, surface);
    if (!visible.importance || !(origins || isPart(bench, surface)))
        return places;
    const std::vector<ImportantRegion>& regions = bench.project().importance;
    for (int i = 0; i < static_cast<int>(regions.size()); ++i) {
        const ImportantRegion& region = regions[static_cast<std::size_t>(i)];
        if (region.faces.empty() || !visible.shows(regionId(i)))
            continue;
        const int middle = middleFace(region, *bench.project().part);
        if (const int shown = origins ? origins->faceFrom(middle) : middle; shown >= 0)
            places.push_back({i, middleOf(*surface.drawn->mesh, shown)});
    }
    return places;
}

int regionAt(const Workbench& bench, const ShownSurface& surface, const Visibility& visible, int face) {
    const auto origins = originsOf(bench, surface);
    if (!visible.importance || !(origins || isPart(bench, surface)))
        return -1;
    const int source = origins ? origins->faces()[static_cast<std::size_t>(face)] : face;
    int found = -1;
    double most = 0;
    const std::vector<ImportantRegion>& regions = bench.project().importance;
    for (int i = 0; i < static_cast<int>(regions.size()); ++i) {
        const ImportantRegion& region = regions[static_cast<std::size_t>(i)];
        const auto at = std::ranges::lower_bound(region.faces, source);
        if (at == region.faces.end() || *at != source || !visible.shows(regionId(i)))
            continue;
        const double weight = region.weights[static_cast<std::size_t>(at - region.faces.begin())];
        if (weight > most) {
            most = weight;
            found = i;
        }
    }
    return found;
}

std::vector<scene::Chip> regionChips(const Workbench& bench, const ShownSurface& surface,
                                     const Visibility& visible, const QString& selected) {
    std::vector<scene::Chip> chips;
    for (const auto& [i, place] : regionPlaces(bench, surface, visible)) {
        const ImportantRegion& region = bench.project().importance[static_cast<std::size_t>(i)];
        const bool chosen = std::ranges::binary_search(regionNumbers(selected), i);
        chips.push_back(
            {place,
             {{},
              {{std::nullopt,
                {{region.name, scene::Ink::Text, chosen}, {weightText(heaviest(region)).toStdString()}},
                {}}}}});
    }
    return chips;
}

} // namespace moldwright
