// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/further_parts.h"

#include "mesh/measures.h"
#include "project/project_file.h"

#include <algorithm>
#include <utility>

namespace moldwright {

namespace {

constexpr const char* fileInFolder = "project.moldwright"; // as `design` writes it

/// What a person calls it: a file by its name, one that has no name of its own by its folder's.
std::string nameOf(const std::filesystem::path& input) {
    const std::filesystem::path plain = input.has_filename() ? input : input.parent_path();
    const bool nameless = plain.filename() == fileInFolder && plain.has_parent_path();
    return (nameless ? plain.parent_path().filename() : plain.stem()).string();
}

std::string freeName(const std::string& name, const std::string& otherwise,
                     const std::vector<std::string>& taken) {
    const auto isFree = [&](const std::string& wanted) {
        return std::ranges::find(taken, wanted) == taken.end();
    };
    if (isFree(name))
        return name;
    std::string numbered = otherwise;
    for (int number = 2; !isFree(numbered); ++number)
        numbered = otherwise + " " + std::to_string(number);
    return numbered;
}

bool sameInValue(const CertifiedCast& a, const CertifiedCast& b) {
    const auto same = [](const auto& x, const auto& y) { return x.rows() == y.rows() && x == y; };
    return a.state == b.state && a.labels == b.labels && same(a.mesh->V, b.mesh->V) &&
           same(a.mesh->F, b.mesh->F);
}

} // namespace

Result<TrayPart> readTrayPart(const std::filesystem::path& input, const std::vector<std::string>& taken) {
    const Result<Project> project = projectAt(input, {});
    if (!project)
        return std::unexpected(project.error());
    if (!project->cast)
        return failure(
            ErrorCode::BadInput,
            MW_TEXT("Project", "{0} holds no finished cast. Run its design to the end and save it first."),
            {input.string()});
    // Only what a mold needs of it: what the bending left beside would be held in memory for nothing.
    return TrayPart{std::make_shared<const CertifiedCast>(*project->cast),
                    freeName(project->name, nameOf(input), taken), input.string(), 1};
}

std::vector<std::string> namesTaken(const Tray& tray) {
    std::vector<std::string> names;
    for (const TrayPart& part : tray)
        names.push_back(part.name);
    return names;
}

double leastDraftDegrees(const CertifiedCast& cast) {
    double least = 1;
    for (int f = 0; f < cast.mesh->faceCount(); ++f)
        if (const Eigen::Vector3d normal = doubleAreaVector(*cast.mesh, f); normal.norm() > 0) {
            const int side = cast.labels[static_cast<std::size_t>(f)] == 1 ? 1 : 2;
            least = std::min(least, normal.normalized().dot(cast.state.directions.of(side)));
        }
    return draftDegrees(least);
}

Project withFurtherPart(Project project, TrayPart part) {
    project.furtherParts.push_back(std::move(part));
    return project;
}

Project withoutFurtherPart(Project project, std::size_t number) {
    project.furtherParts.erase(project.furtherParts.begin() + static_cast<std::ptrdiff_t>(number));
    return project;
}

Project withFurtherCount(Project project, std::size_t number, int count) {
    project.furtherParts.at(number).count = std::clamp(count, 1, mostCavities);
    return project;
}

Project withFurtherName(Project project, std::size_t number, const std::string& name) {
    if (!name.empty())
        project.furtherParts.at(number).name = name;
    return project;
}

Project withFurtherCast(Project project, std::size_t number,
                        const std::shared_ptr<const CertifiedCast>& cast) {
    std::shared_ptr<const CertifiedCast>& known = project.furtherParts.at(number).cast;
    if (!sameInValue(*known, *cast))
        known = cast;
    return project;
}

} // namespace moldwright
