// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/plaque.h"

#include "castability/mold_state.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace moldwright {

namespace {

using Eigen::Vector2d;

constexpr double draft = 5;            // degrees; nothing stands in the grooves, but they are cleaned
constexpr double thinnestStroke = 0.4; // mm: what the usual nozzle of a printer makes
constexpr double smallestLetters = 3;  // mm, of those that fit themselves
constexpr double largestLetters = 8;

std::string replaced(std::string text, const std::string& what, const std::string& by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
        text.replace(at, what.size(), by);
    return text;
}

/// Whether a shape keeps this far inside a convex outline.
bool keepsInside(const PlanShape& shape, const PlanShape& outline, double steel) {
    for (std::size_t k = 0; k < outline.size(); ++k) {
        const Vector2d along = (outline[(k + 1) % outline.size()] - outline[k]).normalized();
        const Vector2d inwards(-along.y(), along.x());
        for (const Vector2d& p : shape)
            if (inwards.dot(p - outline[k]) < steel)
                return false;
    }
    return true;
}

PlanShape rectangleAbout(const Vector2d& place, const Vector2d& size) {
    return planRectangle(place - size / 2, place + size / 2);
}

/// The place for a rectangle that is nearest to the back's middle.
std::optional<Vector2d> placeOn(const PlanShape& back, const Vector2d& size, const Obstacles& openings,
                                double steel) {
    constexpr double searchStep = 1; // mm
    Eigen::AlignedBox2d box;
    for (const Vector2d& p : back)
        box.extend(p);
    const Vector2d middle = box.center();
    const Eigen::Vector2i reach =
        ((box.sizes() - size) / 2 / searchStep).array().floor().max(-1).matrix().cast<int>();
    std::vector<Vector2d> candidates;
    for (int i = -reach.x(); i <= reach.x(); ++i)
        for (int j = -reach.y(); j <= reach.y(); ++j)
            candidates.emplace_back(middle + searchStep * Vector2d(i, j));
    std::stable_sort(candidates.begin(), candidates.end(), [&](const Vector2d& a, const Vector2d& b) {
        return (a - middle).squaredNorm() < (b - middle).squaredNorm();
    });
    for (const Vector2d& place : candidates) {
        const PlanShape shape = rectangleAbout(place, size);
        if (keepsInside(shape, back, steel) && keepsClear(shape, openings, steel))
            return place;
    }
    return std::nullopt;
}

/// Lettering with a place for it.
struct Placed {
    StencilText text;
    double height = 0;
    Vector2d place = Vector2d::Zero();
    bool turned = false; ///< reads upwards, along y
};

/// The largest of these heights that there is room for; none where there is none for any.
Result<std::optional<Placed>> fitted(const std::vector<double>& heights,
                                     const std::vector<std::string>& lines, const PlanShape& back,
                                     const Obstacles& openings, double steel) {
    for (const double height : heights) {
        Result<StencilText> text = stencilText(lines, height);
        if (!text)
            return std::unexpected(text.error());
        for (const bool turned : {false, true}) {
            const Vector2d along = text->box.sizes();
            const Vector2d size = turned ? Vector2d(along.y(), along.x()) : along;
            if (const std::optional<Vector2d> place = placeOn(back, size, openings, steel))
                return Placed{*std::move(text), height, *place, turned};
        }
    }
    return std::nullopt;
}

/// Where a point of the lettering lies on the back. From outside, half 2 is seen mirrored.
PlanShape onBack(const PlanShape& outline, const Placed& placed, int side) {
    PlanShape shape;
    for (const Vector2d& p : outline) {
        Vector2d q = p - placed.text.box.center();
        if (placed.turned)
            q = Vector2d(-q.y(), q.x());
        if (side == 2)
            q.x() = -q.x();
        shape.emplace_back(placed.place + q);
    }
    if (side == 2)
        std::reverse(shape.begin(), shape.end());
    return shape;
}

Result<DraftedPrism> groove(PlanShape outline, double depth, int side, double grid) {
    const std::size_t inwards = side == 1 ? 1 : 0;
    PrismRequest request;
    request.slopes[inwards].assign(outline.size(), std::tan(radians(draft)));
    request.base = std::move(outline);
    request.height[inwards] = depth;
    request.grid = grid;
    return draftedPrism(request);
}

std::unexpected<Error> noRoom(int side, double least) {
    return failure(ErrorCode::Impossible,
                   MW_TEXT("Mold", "The plaque's text has no room on the back of half {0}, not even with "
                                   "letters of {1} mm. Take smaller letters, fewer words, more lines (| "
                                   "between them) or a larger block."),
                   {std::to_string(side), readable(least)});
}

Result<void> refused(const PlaqueSettings& settings, double cover, double steel) {
    const double stroke = settings.height * strokeOfHeight;
    constexpr double rounding = 1e-9;
    if (settings.height > 0 && stroke < thinnestStroke - rounding)
        return failure(ErrorCode::Impossible,
                       MW_TEXT("Mold",
                               "Letters of {0} mm have strokes of {1} mm, and less than {2} mm cannot "
                               "be printed or read. Make them {3} mm high or more."),
                       {readable(settings.height), readable(stroke, 2), readable(thinnestStroke),
                        readable(thinnestStroke / strokeOfHeight)});
    if (settings.depth > cover - steel)
        return failure(ErrorCode::Impossible,
                       MW_TEXT("Mold",
                               "A plaque {0} mm deep leaves less than {1} mm of steel to the cavities. "
                               "Make it shallower, or floor and ceiling thicker."),
                       {readable(settings.depth), readable(steel)});
    return {};
}

/// All of these in one; they do not touch.
IndexedMesh together(const std::vector<SharedMesh>& parts, double back) {
    Eigen::Index points = 0;
    Eigen::Index faces = 0;
    for (const SharedMesh& part : parts) {
        points += part->V.rows();
        faces += part->F.rows();
    }
    IndexedMesh all{Points(points, 3), Triangles(faces, 3)};
    points = faces = 0;
    for (const SharedMesh& part : parts) {
        all.V.middleRows(points, part->V.rows()) = part->V;
        all.F.middleRows(faces, part->F.rows()) = part->F.array() + static_cast<int>(points);
        points += part->V.rows();
        faces += part->F.rows();
    }
    all.V.col(2).array() += back;
    return all;
}

} // namespace

IndexedMesh Plaque::surface() const {
    std::vector<SharedMesh> parts;
    for (const DraftedPrism& stroke : strokes)
        parts.push_back(std::make_shared<const IndexedMesh>(*prismSurface(stroke, 3 - side)));
    return together(parts, back);
}

IndexedMesh Plaque::solid() const {
    std::vector<SharedMesh> parts;
    for (const DraftedPrism& stroke : strokes)
        parts.push_back(std::make_shared<const IndexedMesh>(*prismSolid(stroke)));
    return together(parts, back);
}

std::string plaqueText(const std::string& typed, const PartTitle& title) {
    std::string text = typed;
    if (typed == "auto")
        text = std::string("{part}") + (title.number.empty() ? "" : "|{number}") +
               (title.revision.empty() ? "" : "|REV {revision}") + "|HALF {half}|SHRINK {shrink} %";
    text = replaced(text, "{number}", title.number);
    text = replaced(text, "{revision}", title.revision);
    return replaced(text, "{part}", replaced(title.name, "_", " "));
}

std::vector<std::string> plaqueLines(const PlaqueSettings& settings, const ShrinkSettings& shrink, int side) {
    const Eigen::Vector3d& percent = shrink.percent;
    const bool even = percent.minCoeff() == percent.maxCoeff();
    const std::string shrinks =
        even ? readable(percent.x())
             : readable(percent.x()) + "/" + readable(percent.y()) + "/" + readable(percent.z());
    const std::string text =
        replaced(replaced(settings.text, "{half}", std::to_string(side)), "{shrink}", shrinks);
    std::vector<std::string> lines{{}};
    for (const char c : text)
        if (c == '|')
            lines.emplace_back();
        else
            lines.back().push_back(c);
    return lines;
}

Result<Plaque> plaqueOn(const PlaqueSettings& settings, const std::vector<std::string>& lines, int side,
                        const Block& block, const Obstacles& openings, double cover, double steel) {
    if (Result<void> done = refused(settings, cover, steel); !done)
        return std::unexpected(done.error());
    std::vector<double> heights{settings.height};
    if (settings.height <= 0) {
        heights.clear();
        for (double height = largestLetters; height >= smallestLetters; height -= 0.5)
            heights.push_back(height);
    }
    const Result<std::optional<Placed>> placed =
        fitted(heights, lines, block.body.lid[side == 1 ? 0 : 1], openings, steel);
    if (!placed)
        return std::unexpected(placed.error());
    if (!*placed)
        return noRoom(side, heights.back());
    Plaque plaque;
    plaque.place = (*placed)->place;
    plaque.side = side;
    plaque.back = block.end(side);
    plaque.letterHeight = (*placed)->height;
    for (const std::string& line : lines)
        plaque.text += (plaque.text.empty() ? "" : " | ") + line;
    for (const PlanShape& outline : (*placed)->text.strokes) {
        Result<DraftedPrism> stroke =
            groove(onBack(outline, **placed, side), settings.depth, side, block.body.grid);
        if (!stroke)
            return failure(ErrorCode::Impossible,
                           MW_TEXT("Mold", "Letters of {0} mm are too small for a plaque {1} mm deep: their "
                                           "walls meet. Make it shallower, or them larger."),
                           {readable(plaque.letterHeight), readable(settings.depth)});
        plaque.strokes.push_back(*std::move(stroke));
    }
    return plaque;
}

} // namespace moldwright
