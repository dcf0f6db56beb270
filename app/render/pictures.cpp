// SPDX-License-Identifier: AGPL-3.0-or-later
#include "render/pictures.h"

#include "castability/analysis.h"
#include "castability/cast_analysis.h"
#include "castability/certificate.h"
#include "exchange/mesh_file.h"
#include "mesh/measures.h"
#include "mold/steel_map.h"
#include "scene/offscreen/picture.h"
#include "scene/value_scale.h"

#include <algorithm>
#include <array>
#include <functional>

namespace moldwright::render {

namespace {

using Eigen::Vector3d;
using scene::Rgb;

// About 400 dots an inch in the columns of the report.
constexpr int width = 900;
constexpr int height = 720;
const Vector3d fromFrontRight(1, -1.7, 0.8);
const Vector3d fromAbove(0.35, -1, 1.1);
const Vector3d fromTheSide(0.7, -1, 0.3);

scene::SceneColours onPaper() {
    scene::SceneColours colours = scene::lightColours();
    colours.viewTop = colours.viewBottom = Rgb::hex(0xffffff);
    return colours;
}

std::vector<Rgb> byDraft(const std::vector<double>& draft, double required) {
    std::vector<Rgb> result;
    result.reserve(draft.size());
    for (const double angle : draft)
        result.push_back(
            scene::draftClassColours().at(static_cast<std::size_t>(scene::draftClass(angle, required))));
    return result;
}

/// Half 2 as it lies and half 1 turned over to its right, as one surface with a colour per face.
struct SideBySide {
    SharedMesh mesh;
    std::vector<Rgb> colours;
};

/// `colour(side, face)`: of each face of half 1 and 2.
SideBySide sideBySide(const Mold& mold, const std::array<SharedMesh, 2>& halves,
                      const std::function<Rgb(int side, int face)>& colour) {
    const IndexedMesh& left = *halves[1];
    const IndexedMesh& right = *halves[0];
    const double gap = 0.12 * mold.half1.size.x();
    IndexedMesh both;
    both.V.resize(left.V.rows() + right.V.rows(), 3);
    both.V.topRows(left.V.rows()) = left.V;
    both.V.bottomRows(right.V.rows()) = right.V * Vector3d(-1, 1, -1).asDiagonal();
    both.V.bottomRows(right.V.rows()).col(0).array() += mold.half1.size.x() + gap;
    both.F.resize(left.F.rows() + right.F.rows(), 3);
    both.F << left.F, (right.F.array() + left.vertexCount()).matrix();
    SideBySide result;
    result.mesh = std::make_shared<const IndexedMesh>(std::move(both));
    for (const int side : {2, 1})
        for (int f = 0; f < halves[static_cast<std::size_t>(side - 1)]->faceCount(); ++f)
            result.colours.push_back(colour(side, f));
    return result;
}

Rgb colourOfHalf(int side) {
    return side == 1 ? onPaper().half1 : onPaper().half2;
}

/// Both halves painted by the steel behind their walls.
Result<SideBySide> steelOf(const Mold& mold) {
    std::array<SteelMap, 2> maps;
    for (const int side : {1, 2}) {
        Result<SteelMap> map = steelMap(mold, side);
        if (!map)
            return std::unexpected(map.error());
        maps[static_cast<std::size_t>(side - 1)] = *std::move(map);
    }
    const auto colours = scene::steelColours(onPaper().undercut);
    return sideBySide(mold, {maps[0].surface, maps[1].surface}, [&](int side, int face) {
        const SteelMap& map = maps[static_cast<std::size_t>(side - 1)];
        const double thickness = map.thickness[static_cast<std::size_t>(face)];
        return thickness < 0 ? colourOfHalf(side)
                             : colours.at(static_cast<std::size_t>(map.scale.classOf(thickness)));
    });
}

/// The picture without the empty paper round what is drawn.
Result<void> write(const scene::Picture& picture, const std::filesystem::path& file) {
    return writeFileAtomically(file, scene::pngBytes(scene::cropped(picture, Rgb::hex(0xffffff))));
}

/// The mold opened, upright as in its own frame, with the cast between its halves.
Result<void> drawOpened(const scene::EglContext& context, const Mold& mold,
                        const std::filesystem::path& file) {
    constexpr double opening = 0.4;
    scene::Scene view;
    view.setLook(onPaper(), 2);
    view.setSurface(scene::drawnMesh(mold.cast), {});
    view.setHalves(scene::drawnMesh(mold.half1.mesh), scene::drawnMesh(mold.half2.mesh),
                   Eigen::Isometry3d::Identity(), mold.directions);
    view.setOpening({opening});
    return write(scene::renderPicture(view, context, fromTheSide, width, height), file);
}

/// Draws one surface and writes the picture.
Result<void> draw(const scene::EglContext& context, const SharedMesh& mesh, const std::vector<Rgb>& colours,
                  const Vector3d& from, int wide, int high, const std::filesystem::path& file) {
    scene::Scene view;
    view.setLook(onPaper(), 2);
    view.setSurface(scene::drawnMesh(mesh), colours);
    return write(scene::renderPicture(view, context, from, wide, high), file);
}

/// Draft of each face; of a surface that is parted already, by the side that each face belongs to.
std::vector<double> draftOf(const IndexedMesh& mesh, const MoldState& state, double draftDegrees) {
    const SideLabels labels = labelSides(mesh, state.plane);
    if (std::ranges::find(labels, 0) != labels.end())
        return analyzeDraft(mesh, state, draftDegrees, false).faceDraft;
    return analyzeCast(mesh, labels, state, draftDegrees).faceDraft;
}

scene::ShownPins shownPins(const SurfaceLook& look) {
    scene::ShownPins shown;
    for (const Vector3d& pin : look.pins) {
        shown.pins.push_back({static_cast<int>(shown.pins.size()), pin, std::nullopt, false});
        if (look.state)
            shown.pins.back().onPlane = pin - look.state->plane.distance(pin) * look.state->plane.normal;
    }
    shown.suggested = look.suggested;
    return shown;
}

} // namespace

Result<void> drawReportPictures(const Project& project, const Evaluation& evaluation,
                                const std::filesystem::path& folder) {
    const Result<std::unique_ptr<scene::EglContext>> context = scene::EglContext::create();
    if (!context)
        return std::unexpected(context.error());
    const auto picture = [&](const SharedMesh& mesh, const std::vector<Rgb>& colours, const Vector3d& from,
                             const char* name) {
        return draw(**context, mesh, colours, from, width, height, folder / name);
    };
    Result<void> done;
    if (project.part)
        done = picture(project.part,
                       evaluation.part ? scene::undercutColours(evaluation.part->violating, onPaper())
                                       : std::vector<Rgb>{},
                       fromFrontRight, partPicture);
    if (done && project.cast) {
        done = picture(project.cast->mesh, {}, fromFrontRight, castPicture);
        if (done && evaluation.cast)
            done =
                picture(project.cast->mesh, byDraft(evaluation.cast->faceDraft, project.cast->draftDegrees),
                        fromFrontRight, draftPicture);
    }
    if (done && evaluation.mold) {
        const Mold& mold = *evaluation.mold;
        const SideBySide halves = sideBySide(mold, {mold.half1.mesh, mold.half2.mesh},
                                             [](int side, int /*face*/) { return colourOfHalf(side); });
        done = picture(halves.mesh, halves.colours, fromAbove, halvesPicture);
        const Result<SideBySide> steel = steelOf(mold);
        if (done && !steel)
            return std::unexpected(steel.error());
        if (done)
            done = picture(steel->mesh, steel->colours, fromAbove, steelPicture);
        if (done)
            done = drawOpened(**context, *evaluation.mold, folder / openedPicture);
    }
    return done;
}

Result<void> drawThumbnail(const Project& project, const std::filesystem::path& file, int wide, int high) {
    const Result<std::unique_ptr<scene::EglContext>> context = scene::EglContext::create();
    if (!context)
        return std::unexpected(context.error());
    scene::Scene view;
    view.setLook(onPaper(), 1);
    view.setSurface(scene::drawnMesh(project.cast ? project.cast->mesh : project.part), {});
    return writeFileAtomically(
        file, scene::pngBytes(scene::renderPicture(view, **context, fromFrontRight, wide, high)));
}

Result<void> drawSurface(const SharedMesh& mesh, const SurfaceLook& look, const std::filesystem::path& file) {
    const Result<std::unique_ptr<scene::EglContext>> context = scene::EglContext::create();
    if (!context)
        return std::unexpected(context.error());
    std::vector<Rgb> colours;
    if (look.state)
        colours = byDraft(draftOf(*mesh, *look.state, look.draftDegrees), look.draftDegrees);
    scene::Scene view;
    view.setLook(onPaper(), 2);
    view.setSurface(scene::drawnMesh(mesh), colours);
    view.setSeeThrough(look.seeThrough);
    view.setPins(shownPins(look));
    return write(scene::renderPicture(view, **context, look.from, look.width, look.height), file);
}

} // namespace moldwright::render
