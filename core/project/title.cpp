// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/title.h"

#include <utility>

namespace moldwright {

namespace {

std::string trimmed(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t");
    return first == std::string::npos ? std::string()
                                      : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

} // namespace

PartTitle titleOf(const Project& project) {
    return {project.name, project.number, project.revision};
}

Project withTitle(Project project, const PartTitle& title) {
    if (std::string name = trimmed(title.name); !name.empty())
        project.name = std::move(name);
    project.number = trimmed(title.number);
    project.revision = trimmed(title.revision);
    return project;
}

MoldSettings moldAsBuilt(const Project& project) {
    MoldSettings settings = project.mold;
    settings.plaque.text = plaqueText(settings.plaque.text, titleOf(project));
    return settings;
}

} // namespace moldwright
