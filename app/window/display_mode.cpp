// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/display_mode.h"

#include <QCoreApplication>

#include <array>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(DisplayMode)
};

} // namespace

std::optional<PartingPlane> planeOf(const SectionCut& cut, const std::optional<MoldState>& state) {
    PartingPlane plane;
    if (cut.across == SectionCut::Across::View && !cut.normal)
        return std::nullopt;
    if (cut.across == SectionCut::Across::View)
        plane.normal = *cut.normal;
    else if (cut.across != SectionCut::Across::Plane)
        plane.normal = Eigen::Vector3d::Unit(static_cast<int>(cut.across) - 1);
    else if (state)
        plane = state->plane;
    else
        return std::nullopt;
    plane.offset += cut.offset;
    return cut.flipped.value_or(false) ? PartingPlane{-plane.normal, -plane.offset} : plane;
}

QStringList displayModeNames() {
    return {Words::tr("Undercuts"),  Words::tr("Draft map"),  Words::tr("Undercut depth"),
            Words::tr("Deviation"),  Words::tr("Difference"), Words::tr("Strain"),
            Words::tr("Importance"), Words::tr("Steel"),      Words::tr("Plain")};
}

QString displayModeCommand(DisplayMode mode) {
    static const std::array<QString, displayModeCount> commands = {
        u"show-undercuts"_s, u"show-draft"_s,      u"show-depth"_s, u"show-deviation"_s, u"show-difference"_s,
        u"show-strain"_s,    u"show-importance"_s, u"show-steel"_s, u"show-plain"_s};
    return commands.at(static_cast<std::size_t>(mode));
}

} // namespace moldwright
