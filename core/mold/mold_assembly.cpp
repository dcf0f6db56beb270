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
constexpr const char* spoutName = "Spout";

const char* nameOf(const HalfBore& bore) {
    return bore.use == HalfBore::Use::Spout ? spoutName : ejectorName;
}

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

SharedMesh shared(IndexedMesh mesh) {
    return std::make_shared<const IndexedMesh>(std::move(mesh));
}

std::string inMillimetres(const Vector3d& size) {
    return readable(size.x()) + " x " + readable(size.y()) + " x " + readable(size.z()) + " mm";
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
    const double end = m_block.end(side);
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
    for (const InsertPocket& pocket : m_pockets)
        if (pocket.prism.stands(side))
            half.voids.push_back(placed(*prismSurface(pocket.prism, side)));
    for (const Plaque& plaque : m_plaques)
        if (plaque.side == side)
            half.voids.push_back(placed(plaque.surface()));
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
        if (Result<void> done = addOverflowSurfaces(side, half, solids); !done)
            return done;
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
    m_mold.blockSize = m_block.box().sizes();
    measureParts();
    m_mold.channelVolume = channels() ? volume(*m_mold.cast) - m_mold.cavityVolume : 0;
    for (const CavityCopy& copy : m_layout.copies)
        m_mold.sprueVolume += m_joined[copy.kind].spoutVolume;
    m_mold.channelVolume += m_mold.sprueVolume;
    m_mold.sprues = sprues();
    for (std::size_t i = 0; i < m_openTails.size(); ++i)
        m_mold.otherVolume += volumeOf(m_openTails[i]) - volumeOf(m_closedTails[i]);
    for (const WedgeSlit& slit : m_slits)
        m_mold.otherVolume += volumeOf(slit.prism);
    for (const RegistrationKey& key : m_keys)
        m_mold.otherVolume += volumeOf(key.socket) - volumeOf(key.key);
    for (const PlanShape& bolt : m_bolts)
        m_mold.otherVolume += volume(boltSolid(bolt, m_block));
    for (const InsertPocket& pocket : m_pockets)
        m_mold.otherVolume += volumeOf(pocket.prism);
    for (const Plaque& plaque : m_plaques)
        m_mold.otherVolume += volume(plaque.solid());
    for (const CavityCopy& copy : m_layout.copies)
        m_mold.otherVolume += m_joined[copy.kind].pinVolume;
    const auto curves = partingCurves(*m_mold.cast, labelSides(*m_mold.cast, {}));
    m_mold.partingArea = curves ? enclosedArea(*m_mold.cast, *curves) : 0;
    // cm² × bar / 100 = kN.
    m_mold.clampForce = m_mold.partingArea / 100 * settings.pressure / 100 * clampAllowance;
    compareWithMachines();
    if (m_mold.sprueVolume > 0)
        m_mold.notes.push_back(
            {MW_TEXT("Mold",
                     "Each spout through half 1 holds its sprue and breaks off at a neck of {0} mm: the cast "
                     "is proved without it. Push the sprues out of half 1 outwards."),
             {readable(spout().neck, 3)}});
    return {};
}

/// Each kind once; cavities of a part differ by what rounding does to a turned one.
void MoldBuilder::measureParts() {
    const double wall = m_mold.settings.hollow.wall;
    std::vector<double> ofKind;
    for (const CavityKind& kind : kinds())
        ofKind.push_back(wall > 0 ? shellVolume(kind.cast, wall) : 0);
    for (const CavityCopy& copy : m_layout.copies) {
        const CavityKind& kind = kinds()[copy.kind];
        PartOfMold& part = m_mold.parts[kind.part];
        if (part.cavities++ == 0) {
            part.volume = kind.volume;
            part.shellVolume = ofKind[copy.kind];
        }
        m_mold.cavityVolume += kind.volume;
        m_mold.shellVolume += ofKind[copy.kind];
    }
}

Result<void> MoldBuilder::measureSteel() {
    constexpr double furthest = 1000;
    m_mold.hollows = hollows();
    m_mold.block = m_block;
    m_mold.steelOfEach = thinnestSteel(m_mold.hollows, m_block, furthest, *m_trees);
    m_mold.steel = byNames(m_mold.steelOfEach);
    m_mold.minWall = m_mold.steel.front().thickness;
    m_mold.minWallPlace = m_mold.steel.front().place;
    for (const ThinSteel& thin : m_mold.steel)
        if (thin.thickness < m_mold.settings.leastSteel)
            m_mold.notes.push_back({MW_TEXT("Mold", "Only {0} mm of steel between {1} and {2}."),
                                    {readable(thin.thickness, 3), thin.first, thin.second}});
    listFeatures();
    return {};
}

/// Notes of what the machines cannot do; each half is printed on its back.
void MoldBuilder::compareWithMachines() {
    const MachineSettings& machines = m_mold.settings.machines;
    const Vector3d& bed = machines.bed;
    for (const int side : {1, 2}) {
        const Vector3d& size = (side == 1 ? m_mold.half1 : m_mold.half2).size;
        const auto fits = [&](double x, double y) {
            return x <= bed.x() && y <= bed.y() && size.z() <= bed.z();
        };
        if (bed.minCoeff() > 0 && !fits(size.x(), size.y()) && !fits(size.y(), size.x()))
            m_mold.notes.push_back({MW_TEXT("Mold", "Half {0} of {1} is larger than the printer's {2}."),
                                    {std::to_string(side), inMillimetres(size), inMillimetres(bed)}});
    }
    if (machines.clamp > 0 && m_mold.clampForce > machines.clamp)
        m_mold.notes.push_back(
            {MW_TEXT("Mold", "The mold needs {0} kN to stay closed; the press has {1} kN."),
             {readable(m_mold.clampForce, 3), readable(machines.clamp, 3)}});
}

SharedMesh MoldBuilder::sprues() const {
    std::vector<PlacedSurface> all;
    for (std::size_t kind = 0; kind < m_joined.size(); ++kind)
        for (const HalfBore& bore : m_joined[kind].bores) {
            if (bore.use != HalfBore::Use::Spout)
                continue;
            const PlacedSurface sprue = placed(bore.solid(m_mold.directions.of(bore.side), m_grid));
            for (const CavityCopy& copy : m_layout.copies)
                if (copy.kind == kind)
                    all.push_back({sprue.mesh, copy.offset});
        }
    return all.empty() ? nullptr : std::make_shared<const IndexedMesh>(sumOf(all).mesh);
}

/// Why there is no steel between two, and what helps.
Message MoldBuilder::collision(const ThinSteel& thin) const {
    const auto named = [](const std::string& name, int number) {
        return number > 0 ? name + ' ' + std::to_string(number) : name;
    };
    const auto byHand = [&](const std::string& name, int number) {
        return std::ranges::any_of(m_mold.hollows, [&](const Hollow& hollow) {
            return hollow.byHand && hollow.name == name && hollow.number == number;
        });
    };
    const std::string first = named(thin.first, thin.firstNumber);
    const std::string second = named(thin.second, thin.secondNumber);
    if (byHand(thin.first, thin.firstNumber) || byHand(thin.second, thin.secondNumber))
        return {MW_TEXT("Mold", "There is no steel between {0} and {1}. Move one of them, or have it placed "
                                "automatically."),
                {first, second}};
    if (first == second)
        return {MW_TEXT("Mold",
                        "{0} meets the same of the next cavity. Give the cavities more spacing, or make it "
                        "smaller."),
                {first}};
    return {MW_TEXT("Mold",
                    "There is no steel between {0} and {1}. Give the cavities more spacing, or take fewer "
                    "or smaller features."),
            {first, second}};
}

Result<void> MoldBuilder::refuseCollisions() {
    for (const ThinSteel& thin : m_mold.steelOfEach)
        if (thin.thickness <= 0) {
            Error error;
            error.code = ErrorCode::Impossible;
            error.message = collision(thin);
            error.places.push_back(thin.place);
            return std::unexpected(std::move(error));
        }
    return {};
}

std::vector<Hollow> MoldBuilder::attachedTo(std::size_t kind, int net) const {
    const JoinedCavity& joined = m_joined[kind];
    // Where the runners are one prism, vents go through the halves alone.
    const auto endsInRunner = [&](const Stub& stub) { return !spoutEach() && !(inOnePrism() && stub.vent); };
    std::vector<Hollow> attached;
    for (const Stub& stub : joined.stubs) {
        const bool gate = !stub.vent && !spoutEach();
        const Placeable what = stub.vent ? Placeable::Vent : Placeable::Spout;
        attached.push_back({stub.name,
                            shared(*prismSolid(stub.prism)),
                            {},
                            endsInRunner(stub) ? std::vector{net} : std::vector<int>{},
                            spoutEach(),
                            stub.number + 1,
                            !gate,
                            !gate && isByHand(what, stub.number)});
    }
    for (const CavityVent& vent : joined.vents)
        attached.push_back({"Vent",
                            shared(vent.solid()),
                            {},
                            {},
                            true,
                            vent.number + 1,
                            true,
                            isByHand(Placeable::Vent, vent.number)});
    for (const HalfBore& bore : joined.bores) {
        const Placeable what = bore.use == HalfBore::Use::Pin ? Placeable::Ejector : Placeable::Spout;
        attached.push_back({nameOf(bore),
                            shared(bore.solid(m_mold.directions.of(bore.side), m_grid)),
                            {},
                            {},
                            true,
                            bore.number + 1,
                            true,
                            isByHand(what, bore.number)});
    }
    return attached;
}

std::vector<Hollow> MoldBuilder::hollows() const {
    std::vector<Hollow> all;
    std::vector<std::vector<Hollow>> attached; // by kind
    const int net = static_cast<int>(m_layout.copies.size());
    for (std::size_t kind = 0; kind < kinds().size(); ++kind)
        attached.push_back(attachedTo(kind, net));
    for (int c = 0; c < net; ++c) {
        const CavityCopy& copy = m_layout.copies[static_cast<std::size_t>(c)];
        // The kinds live as long as the builder or its copies, and their trees with them.
        all.push_back(
            {"Cavity", SharedMesh(m_shapes, &kinds()[copy.kind].cast), copy.offset, {c}, false, c + 1});
        for (Hollow hollow : attached[copy.kind]) {
            hollow.offset = copy.offset;
            hollow.joints.push_back(c);
            all.push_back(std::move(hollow));
        }
    }
    for (const Channel& channel : m_net.channels) {
        const bool main = channel.name == "Spout";
        all.push_back({channel.name,
                       shared(*prismSolid(channel.prism)),
                       Vector2d::Zero(),
                       {net},
                       main,
                       main ? 1 : 0,
                       main,
                       main && !inOnePrism() && isByHand(Placeable::Spout, 0)});
    }
    addOverflows(all);
    const auto add = [&](const char* name, IndexedMesh mesh, bool opensOutside, Placeable kind, int number) {
        all.push_back({name,
                       shared(std::move(mesh)),
                       Vector2d::Zero(),
                       {},
                       opensOutside,
                       number + 1,
                       true,
                       isByHand(kind, number)});
    };
    for (std::size_t i = 0; i < m_keys.size(); ++i)
        add("Key", *prismSolid(m_keys[i].socket), false, Placeable::Key, static_cast<int>(i));
    for (std::size_t i = 0; i < m_bolts.size(); ++i)
        add(boltName, boltSolid(m_bolts[i], m_block), true, Placeable::Bolt, static_cast<int>(i));
    for (std::size_t i = 0; i < m_slits.size(); ++i)
        add("Slit", *prismSolid(m_slits[i].prism), true, Placeable::Slit, static_cast<int>(i));
    for (std::size_t i = 0; i < m_pockets.size(); ++i)
        add("Pocket", *prismSolid(m_pockets[i].prism), false, Placeable::Pocket, static_cast<int>(i));
    for (const Plaque& plaque : m_plaques)
        all.push_back({"Plaque", shared(plaque.solid()), Vector2d::Zero(), {}, true, plaque.side, true});
    return all;
}

} // namespace moldwright
