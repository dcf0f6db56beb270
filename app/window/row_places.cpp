// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/row_places.h"

#include "window/importance_pages.h"
#include "window/mold_feature_pages.h"
#include "window/mold_placing.h"
#include "window/obstruction_words.h"
#include "window/pin_pages.h"
#include "window/refusal_pages.h"
#include "window/refused_mesh.h"
#include "window/tray_pages.h"
#include "window/undercut_pages.h"
#include "window/workbench.h"

namespace moldwright {

using namespace Qt::StringLiterals;
using Eigen::AlignedBox3d;

namespace {

constexpr double aboutPoint = 0.12; ///< of the part's diagonal, to each side of a point

AlignedBox3d aroundPoint(const Eigen::Vector3d& point, const Workbench& bench) {
    const double reach = aboutPoint * bench.figures(bench.project().part).box.diagonal().norm();
    return {point - Eigen::Vector3d::Constant(reach), point + Eigen::Vector3d::Constant(reach)};
}

AlignedBox3d aroundPins(int pin, const Workbench& bench) {
    AlignedBox3d box;
    const std::vector<Pin> pins = bench.pinsInView();
    for (int i = 0; i < static_cast<int>(pins.size()); ++i)
        if (pin < 0 || i == pin)
            box.extend(aroundPoint(pins[static_cast<std::size_t>(i)].point, bench));
    return box;
}

AlignedBox3d aroundRegions(int region, const Workbench& bench) {
    AlignedBox3d box;
    const IndexedMesh& part = *bench.project().part;
    const auto& regions = bench.project().importance;
    for (int i = 0; i < static_cast<int>(regions.size()); ++i)
        if (region < 0 || i == region)
            for (const int f : regions[static_cast<std::size_t>(i)].faces)
                for (int k = 0; k < 3; ++k)
                    box.extend(part.corner(f, k));
    return box;
}

/// So wide that one sees where in the part it is.
AlignedBox3d aroundFault(const RefusedMesh& refused, int number) {
    AlignedBox3d box = refused.places[static_cast<std::size_t>(number)].box;
    const Eigen::Vector3d reach =
        Eigen::Vector3d::Constant(aboutPoint * refused.drawn->box.diagonal().norm());
    box.extend(box.center() + reach);
    box.extend(box.center() - reach);
    return box;
}

AlignedBox3d aroundFeature(const FeatureName& feature, const Workbench& bench) {
    AlignedBox3d box;
    const MoldSketch* sketch = bench.placing().sketch();
    const PlacedRow* row = bench.placing().row(feature.kind, feature.number);
    if (!sketch || !row)
        return box;
    const Eigen::Isometry3d toPart = sketch->partToMold.inverse();
    for (const MoldFeature* copy : row->copies)
        for (const Eigen::Vector2d& p : copy->outline)
            box.extend(aroundPoint(toPart * Eigen::Vector3d(p.x(), p.y(), 0), bench));
    return box;
}

} // namespace

AlignedBox3d placeOfRow(const QString& id, const Workbench& bench) {
    if (const RefusedMesh* refused = bench.refused()) {
        const int number = faultNumber(id);
        const bool isPlace = number >= 0 && number < listedFaults(*refused);
        return isPlace ? aroundFault(*refused, number) : refused->drawn->box;
    }
    if (const int number = obstructionNumber(id);
        number >= 0 && number < static_cast<int>(bench.obstructions().size()))
        return bench.placeOf(number);
    if (const int number = undercutNumber(id);
        number >= 0 && number < static_cast<int>(bench.undercuts().size()))
        return bench.placeOfUndercut(number);
    if (const auto feature = featureOf(id))
        return aroundFeature(*feature, bench);
    if (trayNumber(id) >= 0)
        return trayPlace(trayNumber(id), bench);
    if (pinsChosen(id))
        return aroundPins(pinNumber(id), bench);
    if (regionsChosen(id))
        return aroundRegions(regionNumber(id), bench);
    if (id == u"part"_s || id == u"surface"_s || id == u"cast"_s)
        return bench.figures(bench.shownMesh()).box;
    return {};
}

} // namespace moldwright
