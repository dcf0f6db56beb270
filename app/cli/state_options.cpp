// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/state_options.h"

#include "castability/directions.h"
#include "cli/option_values.h"

#include <CLI/CLI.hpp>

#include <charconv>
#include <cmath>

namespace moldwright::cli {

namespace {

std::optional<double> numberIn(const std::string& text) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

} // namespace

void StateOptions::declare(CLI::App& app, bool planeRequired) {
    CLI::Option* option = app.add_option("--plane", plane,
                                         planeRequired ? "Parting plane n·x = o as nx ny nz o"
                                                       : "Parting plane as nx ny nz o, or auto")
                              ->type_name("N N N O")
                              ->expected(planeRequired ? 4 : 1, 4);
    if (planeRequired)
        option->required();
    app.add_option("--d1", d1, "Removal direction of side 1 (n·x > o)")->type_name("X Y Z")->expected(3);
    app.add_option("--d2", d2, "Removal direction of side 2")->type_name("X Y Z")->expected(3);
    app.add_option("--draft", draft, "Draft angle that every face needs, degrees")
        ->check(fromTo(0.0, 45.0))
        ->capture_default_str();
}

Result<std::optional<PartingPlane>> StateOptions::givenPlane() const {
    if (plane.empty() || (plane.size() == 1 && plane.front() == "auto"))
        return std::nullopt;
    const auto refusal =
        failure(ErrorCode::Usage,
                MW_TEXT("cli", "--plane takes four numbers, nx ny nz o, with a normal that is not zero."));
    if (plane.size() != 4)
        return refusal;
    double numbers[4];
    for (std::size_t i = 0; i < 4; ++i) {
        const std::optional<double> number = numberIn(plane[i]);
        if (!number)
            return refusal;
        numbers[i] = *number;
    }
    const Eigen::Vector3d n(numbers[0], numbers[1], numbers[2]);
    const double length = n.norm();
    if (!(length > 0))
        return refusal;
    // A normal that is unit already keeps its bits, so that what was written is what is read.
    if (std::abs(length - 1) < 1e-12)
        return PartingPlane{n, numbers[3]};
    return PartingPlane{n / length, numbers[3] / length};
}

Result<std::optional<Directions>>
StateOptions::givenDirections(const std::optional<PartingPlane>& given) const {
    if (d1.empty() && d2.empty())
        return std::nullopt;
    if (d1.empty() || d2.empty() || !given)
        return failure(ErrorCode::Usage,
                       MW_TEXT("cli", "--d1, --d2 and --plane belong together: give all three."));
    const auto unit = [](const std::vector<double>& v) {
        const Eigen::Vector3d d(v[0], v[1], v[2]);
        return std::abs(d.norm() - 1) < 1e-12 ? d : Eigen::Vector3d(d.normalized());
    };
    const Directions directions{unit(d1), unit(d2)};
    if (!(directions.d1.dot(given->normal) > 0) || !(directions.d2.dot(given->normal) < 0))
        return failure(ErrorCode::Usage,
                       MW_TEXT("cli", "Direction 1 has to leave the plane on the side of its normal, and "
                                      "direction 2 on the other."));
    return directions;
}

Result<MoldState> StateOptions::moldState() const {
    const Result<std::optional<PartingPlane>> given = givenPlane();
    if (!given)
        return std::unexpected(given.error());
    if (!*given)
        return failure(ErrorCode::Usage, MW_TEXT("cli", "A parting plane is needed: --plane nx ny nz o."));
    const Result<std::optional<Directions>> directions = givenDirections(*given);
    if (!directions)
        return std::unexpected(directions.error());
    return MoldState{**given, *directions ? **directions : Directions::normalTo(**given)};
}

void LimitOptions::declare(CLI::App& app) {
    app.add_option("--max-tilt", maxTilt, "Largest angle of a direction to the plane's normal, degrees")
        ->check(fromTo(0.0, 80.0))
        ->capture_default_str();
    CLI::Option* option =
        app.add_option("--axis", axis, "Axis that both directions keep to, whichever way round")
            ->type_name("X Y Z")
            ->expected(3);
    app.add_option("--cone", cone, "Largest angle of a direction to the axis, degrees")
        ->check(fromTo(0.0, 80.0))
        ->capture_default_str()
        ->needs(option);
}

Result<DirectionLimits> LimitOptions::limits() const {
    DirectionLimits limits{maxTilt, {}, cone};
    if (axis.empty())
        return limits;
    const Eigen::Vector3d given(axis[0], axis[1], axis[2]);
    if (!(given.norm() > 0) || !given.allFinite())
        return failure(ErrorCode::Usage, MW_TEXT("cli", "--axis takes three numbers that are not all zero."));
    limits.axis = given.normalized();
    return limits;
}

Result<MoldState> bestStateAt(const StateOptions& state, const LimitOptions& limits,
                              const IndexedMesh& part) {
    const Result<std::optional<PartingPlane>> plane = state.givenPlane();
    if (!plane)
        return std::unexpected(plane.error());
    const Result<std::optional<Directions>> directions = state.givenDirections(*plane);
    if (!directions)
        return std::unexpected(directions.error());
    if (*directions)
        return MoldState{**plane, **directions};
    const Result<DirectionLimits> allowed = limits.limits();
    if (!allowed)
        return std::unexpected(allowed.error());
    if (!allows(*allowed, (*plane)->normal))
        return failure(ErrorCode::Usage, MW_TEXT("cli", "The plane lies too far from square to --axis: no "
                                                        "direction keeps to --max-tilt and --cone."));
    return MoldState{**plane, bestDirections(part, **plane, state.draft, *allowed)};
}

Json jsonOf(const PartingPlane& plane) {
    return {plane.normal.x(), plane.normal.y(), plane.normal.z(), plane.offset};
}

} // namespace moldwright::cli
