// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/variants.h"

#include <algorithm>
#include <utility>

namespace moldwright {

namespace {

Variant& at(Project& project, std::size_t number) {
    if (number == project.place)
        return project;
    return project.others[number < project.place ? number : number - 1];
}

/// The current variant goes back among the others.
std::vector<Variant> all(Project& project) {
    std::vector<Variant> variants = std::exchange(project.others, {});
    variants.insert(variants.begin() + static_cast<std::ptrdiff_t>(project.place),
                    std::move(static_cast<Variant&>(project)));
    return variants;
}

/// One of them becomes the current one.
Project arranged(Project project, std::vector<Variant> variants, std::size_t place) {
    const auto current = variants.begin() + static_cast<std::ptrdiff_t>(place);
    static_cast<Variant&>(project) = std::move(*current);
    variants.erase(current);
    project.others = std::move(variants);
    project.place = place;
    return project;
}

std::string_view trimmed(std::string_view name) {
    constexpr std::string_view blanks = " \t\r\n";
    const std::size_t first = name.find_first_not_of(blanks);
    return first == std::string_view::npos ? std::string_view()
                                           : name.substr(first, name.find_last_not_of(blanks) + 1 - first);
}

} // namespace

std::size_t variantCount(const Project& project) {
    return project.others.size() + 1;
}

const Variant& variantAt(const Project& project, std::size_t number) {
    if (number == project.place)
        return project;
    return project.others.at(number < project.place ? number : number - 1);
}

std::optional<std::size_t> variantNamed(const Project& project, std::string_view name) {
    for (std::size_t i = 0; i < variantCount(project); ++i)
        if (variantAt(project, i).variantName == name)
            return i;
    return std::nullopt;
}

Result<Project> atVariant(Project project, const std::string& name, const std::string& fileName) {
    if (name.empty())
        return project;
    const auto number = variantNamed(project, name);
    if (!number)
        return failure(ErrorCode::Usage, MW_TEXT("Project", "{0} has no variant {1}. It has: {2}."),
                       {fileName, name, variantNames(project)});
    return withVariant(std::move(project), *number);
}

Tray trayOf(const Variant& variant, const std::string& name) {
    Tray tray = {{variant.cast, name, {}, 1}};
    tray.insert(tray.end(), variant.furtherParts.begin(), variant.furtherParts.end());
    return tray;
}

std::string variantNames(const Project& project) {
    std::string names;
    for (std::size_t i = 0; i < variantCount(project); ++i)
        names += (i > 0 ? ", " : "") + variantAt(project, i).variantName;
    return names;
}

std::string freeVariantName(const Project& project) {
    for (int round = 1;; ++round)
        for (char letter = 'A'; letter <= 'Z'; ++letter)
            if (const std::string name = letter + (round > 1 ? std::to_string(round) : std::string());
                !variantNamed(project, name))
                return name;
}

Project withVariant(Project project, std::size_t number) {
    if (number == project.place)
        return project;
    std::vector<Variant> variants = all(project);
    return arranged(std::move(project), std::move(variants), number);
}

Project withDuplicate(Project project, std::size_t number) {
    Variant copy = variantAt(project, number);
    copy.variantName = freeVariantName(project);
    std::vector<Variant> variants = all(project);
    variants.insert(variants.begin() + static_cast<std::ptrdiff_t>(number) + 1, std::move(copy));
    return arranged(std::move(project), std::move(variants), number + 1);
}

Project withFreshVariant(Project project) {
    Variant fresh;
    fresh.variantName = freeVariantName(project);
    fresh.state = project.state;
    fresh.design = project.design;
    fresh.mold = project.mold;
    fresh.furtherParts = project.furtherParts;
    std::vector<Variant> variants = all(project);
    variants.push_back(std::move(fresh));
    const std::size_t last = variants.size() - 1;
    return arranged(std::move(project), std::move(variants), last);
}

Project withoutVariant(Project project, std::size_t number) {
    if (project.others.empty())
        return project;
    std::size_t place = project.place;
    std::vector<Variant> variants = all(project);
    variants.erase(variants.begin() + static_cast<std::ptrdiff_t>(number));
    if (number < place)
        --place;
    return arranged(std::move(project), variants, std::min(place, variants.size() - 1));
}

Project withVariantName(Project project, std::size_t number, std::string_view name) {
    name = trimmed(name);
    if (!name.empty() && !variantNamed(project, name))
        at(project, number).variantName = name;
    return project;
}

} // namespace moldwright
