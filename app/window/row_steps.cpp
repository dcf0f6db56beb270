// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/row_steps.h"

#include "project/variants.h"
#include "window/importance_pages.h"
#include "window/mold_feature_pages.h"
#include "window/mold_placing.h"
#include "window/obstruction_words.h"
#include "window/pin_pages.h"
#include "window/refusal_pages.h"
#include "window/selection.h"
#include "window/tray_pages.h"
#include "window/undercut_pages.h"
#include "window/variant_pages.h"
#include "window/workbench.h"

namespace moldwright {

using namespace Qt::StringLiterals;

Step stepOf(const QString& id) {
    return id == u"plane"_s || id.startsWith(u"direction"_s)                                 ? Step::Plane
           : pinsChosen(id) || regionsChosen(id)                                             ? Step::Guides
           : id == u"deform"_s || obstructionNumber(id) >= 0 || id.startsWith(u"undercut"_s) ? Step::Deform
           : id == u"cast"_s                                                                 ? Step::Check
           : id == u"mold"_s || id.startsWith(u"half"_s) || id.startsWith(u"feature-"_s) ||
                   trayNumber(id) >= 0
               ? Step::Mold
               : Step::Part;
}

QString stillThere(const QString& selected, const Workbench& bench) {
    if (const RefusedMesh* refused = bench.refused())
        return faultNumber(selected) < listedFaults(*refused) ? selected : refusedId();
    if (severalChosen(selected)) {
        QStringList left = chosenIds(selected);
        left.removeIf([&](const QString& id) { return stillThere(id, bench) != id; });
        return left.isEmpty() ? stillThere(chosenIds(selected).back(), bench) : left.join(u' ');
    }
    const auto isGone = [](int number, std::size_t count) { return number >= static_cast<int>(count); };
    if (isGone(obstructionNumber(selected), bench.obstructions().size()) ||
        isGone(undercutNumber(selected), bench.undercuts().size()))
        return u"deform"_s;
    const std::size_t variants = variantCount(bench.document().committed());
    if (isGone(variantNumber(selected), variants) || (variants == 1 && variantNumber(selected) >= 0))
        return allVariantsId();
    if (const auto feature = featureOf(selected);
        feature && !bench.placing().row(feature->kind, feature->number))
        return u"mold"_s;
    if (trayNumber(selected) >= 0 && isGone(trayNumber(selected), trayRowCount(bench)))
        return u"mold"_s;
    if (isGone(pinNumber(selected), bench.project().pins.size()))
        return u"pins"_s;
    return isGone(regionNumber(selected), bench.project().importance.size()) ? allRegionsId() : selected;
}

} // namespace moldwright
