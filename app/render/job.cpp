// SPDX-License-Identifier: AGPL-3.0-or-later
#include "render/job.h"

#include "project/project_file.h"
#include "project/variants.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace moldwright::render {

namespace {

constexpr std::array<const char*, 4> taskNames = {"report", "pictures", "thumbnail", "surface"};
constexpr int largestPicture = 8192;

Eigen::Vector3d triple(const nlohmann::json& numbers) {
    return {numbers.at(0).get<double>(), numbers.at(1).get<double>(), numbers.at(2).get<double>()};
}

std::vector<Eigen::Vector3d> placesIn(const nlohmann::json& order, const char* key) {
    std::vector<Eigen::Vector3d> places;
    for (const nlohmann::json& place : order.value(key, nlohmann::json::array()))
        places.push_back(triple(place));
    return places;
}

MoldState stateIn(const nlohmann::json& order) {
    const nlohmann::json& plane = order.at("plane");
    return {{triple(plane), plane.at(3).get<double>()}, {triple(order.at("d1")), triple(order.at("d2"))}};
}

SurfaceLook lookIn(const nlohmann::json& order) {
    SurfaceLook look;
    if (order.contains("plane")) {
        look.state = stateIn(order);
        look.draftDegrees = order.at("draft").get<double>();
    }
    if (order.contains("from"))
        look.from = triple(order.at("from"));
    look.seeThrough = order.value("see_through", false);
    look.pins = placesIn(order, "pins");
    look.suggested = placesIn(order, "suggested");
    return look;
}

} // namespace

Result<Project> projectOf(const Job& job) {
    Result<StoredProject> stored = openProject(job.source);
    if (!stored)
        return std::unexpected(stored.error());
    return atVariant(std::move(stored->project), job.variant, job.source.filename().string());
}

Result<Job> readJob(const std::string& json) {
    const auto refused = [] {
        return failure(ErrorCode::Usage, MW_TEXT("Pictures", "The picture program was given an order that it "
                                                             "does not understand."));
    };
    try {
        const auto parsed = nlohmann::json::parse(json);
        const auto task = std::find(taskNames.begin(), taskNames.end(), parsed.at("task").get<std::string>());
        if (task == taskNames.end())
            return refused();
        Job job;
        job.task = static_cast<Job::Task>(task - taskNames.begin());
        const bool ofMesh = job.task == Job::Task::Surface;
        job.source = parsed.at(ofMesh ? "mesh" : "project").get<std::string>();
        if (ofMesh)
            job.look = lookIn(parsed);
        job.out = parsed.at("out").get<std::string>();
        job.variant = parsed.value("variant", "");
        job.language = parsed.value("language", "");
        job.width = std::clamp(parsed.value("width", job.width), 16, largestPicture);
        job.height = std::clamp(parsed.value("height", job.height), 16, largestPicture);
        job.look.width = job.width;
        job.look.height = job.height;
        return job;
    } catch (const nlohmann::json::exception&) {
        return refused();
    }
}

std::string jobText(const Job& job) {
    return nlohmann::json{{"task", taskNames.at(static_cast<std::size_t>(job.task))},
                          {"project", job.source.string()},
                          {"out", job.out.string()},
                          {"variant", job.variant},
                          {"language", job.language},
                          {"width", job.width},
                          {"height", job.height}}
        .dump();
}

} // namespace moldwright::render
