// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/star_runners.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace moldwright {

namespace {

using Eigen::Vector2d;

/// The outline of spout and arms, and which edge each arm ends in.
struct Star {
    PlanShape outline;
    std::vector<std::size_t> ends;
    std::size_t mouth = 0; ///< the edge along the top, right to left
};

Star starAbout(const Layout& layout, const SpoutSettings& spout, const ChannelWidths& widths,
               const FaceEnd& face) {
    const ChannelRay up{Vector2d::UnitY(), widths.main / 2};
    std::vector<ChannelRay> arms;
    for (const Vector2d& way : layout.arms)
        arms.push_back({way, widths.runner / 2});
    Star star;
    const auto addCorner = [&](const std::optional<Vector2d>& corner) {
        if (corner)
            star.outline.push_back(layout.hub + *corner);
    };
    addCorner(cornerBetween(up, arms.front()));
    for (std::size_t i = 0; i < arms.size(); ++i) {
        const Vector2d across = arms[i].half * Vector2d(-arms[i].way.y(), arms[i].way.x());
        const Vector2d end = layout.hub + layout.armEnd * arms[i].way;
        star.ends.push_back(star.outline.size());
        star.outline.push_back(end - across);
        star.outline.push_back(end + across);
        if (i + 1 < arms.size())
            addCorner(cornerBetween(arms[i], arms[i + 1]));
    }
    addCorner(cornerBetween(arms.back(), up));
    star.mouth = addSpoutAbove(star.outline, layout.hub.x(), star.outline.back().y() + widths.beside, spout,
                               widths, face);
    return star;
}

} // namespace

double starHub(int count, double arm, double main) {
    double reach = 0;
    const auto between = [&](const ChannelRay& a, const ChannelRay& b) {
        if (const std::optional<Vector2d> corner = cornerBetween(a, b))
            reach = std::max(reach, corner->norm());
    };
    const auto at = [](double turn) {
        return Vector2d(std::cos(2 * std::numbers::pi * turn), std::sin(2 * std::numbers::pi * turn));
    };
    between({at(0), main / 2}, {at(0.5 / count), arm / 2});
    if (count > 1)
        between({at(0), arm / 2}, {at(1.0 / count), arm / 2});
    return reach;
}

Result<RunnerNet> starNet(const Layout& layout, const std::vector<std::vector<Stub>>& stubsOfKind,
                          const SpoutSettings& spout, const ChannelWidths& widths, const ChannelRules& rules,
                          const FaceEnd& end) {
    const Star star = starAbout(layout, spout, widths, end);
    Result<DraftedPrism> prism =
        rules.prism(star.outline, heightOverWidth * widths.main, {{star.mouth, {0, 0}}});
    if (!prism)
        return std::unexpected(prism.error());
    RunnerNet net;
    net.channels.push_back({*std::move(prism), {}, "Spout"});
    Channel& channel = net.channels.front();
    for (std::size_t i = 0; i < layout.copies.size(); ++i) {
        const CavityCopy& copy = layout.copies[i];
        const Stub& stub = stubsOfKind[copy.kind].front();
        if (Result<void> done = carries(channel.prism, stub.prism); !done)
            return std::unexpected(done.error());
        channel.guests.push_back({star.ends[i], &stub.prism, copy.offset});
        net.pathLengths.push_back(end.face - layout.hub.y() + layout.tipRadii[i]);
    }
    return net;
}

} // namespace moldwright
