// SPDX-License-Identifier: AGPL-3.0-or-later
// The second half of the builder's stages: from joined cavities to solids, numbers and the list of features.
#include "base/parallel.h"
#include "castability/parting_curves.h"
#include "mesh/measures.h"
#include "mold/hollow_casting.h"
#include "mold/mold_builder.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr const char* boltName = "Bolt hole";
constexpr const char* ejectorName = "Ejector hole";

/// Presses are chosen with this much in hand over pressure × area (1.1 to 1.2 are usual).
constexpr double clampAllowance = 1.1;

MoldHalf measured(IndexedMesh mesh) {
    MoldHalf half;
    half.volume = volume(mesh);
    half.size = boundingBox(mesh).sizes();
    half.mesh = std::make_shared<const IndexedMesh>(std::move(mesh));
    return half;
}

/// Area that the curves enclose in the plane z = 0; inner curves run the other way and count as holes.
double enclosedArea(const IndexedMesh& cast, const std::vector<PartingCurve>& curves) {
    double doubled = 0;
    for (const PartingCurve& curve : curves)
        for (std::size_t i = 0; i < curve.size(); ++i) {
            const Vector3d a = cast.point(curve[i]);
            const Vector3d b = cast.point(curve[(i + 1) % curve.size()]);
            doubled += a.x() * b.y() - a.y() * b.x();
        }
    return doubled / 2;
}

PlacedSurface placed(IndexedMesh mesh) {
    return {std::make_shared<const IndexedMesh>(std::move(mesh))};
}

double volumeOf(const DraftedPrism& prism) {
    return volume(*prismSolid(prism));
}

std::unexpected<Error> unsound() {
    return failure(
        ErrorCode::Internal,
        MW_TEXT("Mold", "The parting face could not be built: features meet in the parting plane."));
}

} // namespace

void MoldBuilder::addHalf(int side, HalfSurfaces& half, std::vector<PlacedSurface>& solids) {
    const double end = side == 1 ? m_block.max().z() : m_block.min().z();
    std::vector<PlacedSurface> sides;
    for (const JoinedCavity& joined : m_joined)
        sides.push_back(placed(sideOf(joined.hollow, side, end)));
    for (const CavityCopy& copy : m_layout.copies)
        half.voids.push_back({sides[copy.kind].mesh, copy.offset});
    for (const DraftedPrism& tail : m_openTails)
        half.voids.push_back(placed(*prismSurface(tail, side)));
    for (const DraftedPrism& tail : m_closedTails)
        solids.push_back(placed(*prismSurface(tail, side)));
    for (const WedgeSlit& slit : m_slits)
        half.voids.push_back(placed(*prismSurface(slit.prism, side)));
    for (const PlanShape& bolt : m_bolts)
        half.voids.push_back(placed(boltSurface(bolt, end)));
    for (const RegistrationKey& key : m_keys)
        if (side == 1)
            half.voids.push_back(placed(*prismSurface(key.socket, 1)));
        else
            half.bosses.push_back(placed(*prismSurface(key.key, 1)));
}

Result<void> MoldBuilder::assemble() {
    std::vector<PlacedSurface> solids;
    std::array<HalfSurfaces, 2> surfaces;
    for (const int side : {1, 2}) {
        HalfSurfaces& half = surfaces[side == 1 ? 0 : 1];
        addHalf(side, half, solids);
        for (const Channel& channel : m_net.channels) {
            std::optional<IndexedMesh> surface = prismSurface(channel.prism, side, channel.guests);
            if (!surface)
                return unsound();
            half.voids.push_back(placed(*std::move(surface)));
            solids.push_back(half.voids.back());
        }
    }
    for (const JoinedCavity& joined : m_joined) {
        const PlacedSurface solid = placed(joined.solid);
        for (const CavityCopy& copy : m_layout.copies)
            if (copy.kind == static_cast<std::size_t>(&joined - m_joined.data()))
                solids.push_back({solid.mesh, copy.offset});
    }
    std::array<std::optional<IndexedMesh>, 2> halves;
    parallelInvoke({[&] { m_mold.cast = std::make_shared<const IndexedMesh>(sumOf(solids).mesh); },
                    [&] { halves[0] = assembleHalf(1, surfaces[0], m_block); },
                    [&] { halves[1] = assembleHalf(2, surfaces[1], m_block); }});
    if (!halves[0] || !halves[1])
        return unsound();
    m_mold.half1 = measured(*std::move(halves[0]));
    m_mold.half2 = measured(*std::move(halves[1]));
    return {};
}

Result<void> MoldBuilder::measure() {
    const MoldSettings& settings = m_mold.settings;
    m_mold.blockVolume = m_block.volume();
    for (const CavityCopy& copy : m_layout.copies)
        m_mold.cavityVolume += volume(m_kinds[copy.kind].cast);
    if (settings.hollow.wall > 0) {
        std::vector<double> ofKind;
        for (const CavityKind& kind : m_kinds)
            ofKind.push_back(shellVolume(kind.cast, settings.hollow.wall));
        for (const CavityCopy& copy : m_layout.copies)
            m_mold.shellVolume += ofKind[copy.kind];
    }
    m_mold.channelVolume = channels() ? volume(*m_mold.cast) - m_mold.cavityVolume : 0;
    for (const CavityCopy& copy : m_layout.copies)
        m_mold.sprueVolume += m_joined[copy.kind].spoutVolume;
    m_mold.channelVolume += m_mold.sprueVolume;
    for (std::size_t i = 0; i < m_openTails.size(); ++i)
        m_mold.otherVolume += volumeOf(m_openTails[i]) - volumeOf(m_closedTails[i]);
    for (const WedgeSlit& slit : m_slits)
        m_mold.otherVolume += volumeOf(slit.prism);
    for (const RegistrationKey& key : m_keys)
        m_mold.otherVolume += volumeOf(key.socket) - volumeOf(key.key);
    for (const PlanShape& bolt : m_bolts)
        m_mold.otherVolume += volume(boltSolid(bolt, m_block));
    for (const CavityCopy& copy : m_layout.copies)
        m_mold.otherVolume += m_joined[copy.kind].pinVolume;
    const auto curves = partingCurves(*m_mold.cast, labelSides(*m_mold.cast, {}));
    m_mold.partingArea = curves ? enclosedArea(*m_mold.cast, *curves) : 0;
    // cm² × bar / 100 = kN.
    m_mold.clampForce = m_mold.partingArea / 100 * settings.pressure / 100 * clampAllowance;
    constexpr double furthest = 1000;
    m_mold.steel = thinnestSteel(hollows(), m_block, furthest);
    m_mold.minWall = m_mold.steel.front().thickness;
    m_mold.minWallPlace = m_mold.steel.front().place;
    for (const ThinSteel& thin : m_mold.steel)
        if (thin.thickness < settings.leastSteel)
            m_mold.notes.push_back("Only " + readable(thin.thickness, 3) + " mm of steel between " +
                                   thin.first + " and " + thin.second + ".");
    if (m_mold.sprueVolume > 0)
        m_mold.notes.push_back("Each spout through half 1 holds its sprue and breaks off at a neck of " +
                               readable(spout().neck, 3) +
                               " mm: the cast is proved without it. Push the sprues out of half 1 outwards.");
    listFeatures();
    return {};
}

std::vector<Hollow> MoldBuilder::hollows() const {
    const auto shared = [](IndexedMesh mesh) { return std::make_shared<const IndexedMesh>(std::move(mesh)); };
    std::vector<Hollow> all;
    std::vector<SharedMesh> casts;
    std::vector<std::vector<Hollow>> attached; // by kind
    for (std::size_t kind = 0; kind < m_kinds.size(); ++kind) {
        casts.push_back(shared(m_kinds[kind].cast));
        attached.emplace_back();
        for (const Stub& stub : m_joined[kind].stubs)
            attached.back().push_back({stub.name, shared(*prismSolid(stub.prism)), {}, {}, single()});
        for (const ThroughVent& vent : m_joined[kind].vents)
            attached.back().push_back({"Vent", shared(vent.solid()), {}, {}, true});
        for (const HalfBore& bore : m_joined[kind].bores)
            attached.back().push_back(
                {bore.name, shared(bore.solid(m_mold.directions.of(bore.side), m_grid)), {}, {}, true});
    }
    const int net = static_cast<int>(m_layout.copies.size());
    for (int c = 0; c < net; ++c) {
        const CavityCopy& copy = m_layout.copies[static_cast<std::size_t>(c)];
        all.push_back({"Cavity", casts[copy.kind], copy.offset, {c}, false});
        for (Hollow hollow : attached[copy.kind]) {
            hollow.offset = copy.offset;
            hollow.joints = {c};
            // A bore stays apart from the runners.
            if (hollow.name != ejectorName)
                hollow.joints.push_back(net);
            all.push_back(std::move(hollow));
        }
    }
    for (const Channel& channel : m_net.channels)
        all.push_back({channel.name,
                       shared(*prismSolid(channel.prism)),
                       Vector2d::Zero(),
                       {net},
                       channel.name == "Spout"});
    for (const RegistrationKey& key : m_keys)
        all.push_back({"Key", shared(*prismSolid(key.socket)), Vector2d::Zero(), {}, false});
    for (const PlanShape& bolt : m_bolts)
        all.push_back({boltName, shared(boltSolid(bolt, m_block)), Vector2d::Zero(), {}, true});
    for (const WedgeSlit& slit : m_slits)
        all.push_back({"Slit", shared(*prismSolid(slit.prism)), Vector2d::Zero(), {}, true});
    return all;
}

} // namespace moldwright
