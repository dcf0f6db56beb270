// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/document_hash.h"

#include "project/project_json.h"

#include <nlohmann/json.hpp>

#include <functional>
#include <string_view>

namespace moldwright::test {

namespace {

std::size_t hashOf(const SharedMesh& mesh) {
    if (!mesh)
        return 1;
    const auto bytes = [](const auto& matrix) {
        return std::string_view(reinterpret_cast<const char*>(matrix.data()),
                                static_cast<std::size_t>(matrix.size()) * sizeof(*matrix.data()));
    };
    return std::hash<std::string_view>()(bytes(mesh->V)) * 31 + std::hash<std::string_view>()(bytes(mesh->F));
}

} // namespace

std::size_t hashOf(const Project& project) {
    std::size_t hash = std::hash<std::string>()(documentJson(project).dump());
    const auto add = [&](const SharedMesh& mesh) { hash = hash * 1099511628211U + hashOf(mesh); };
    add(project.source);
    add(project.part);
    add(project.cast ? project.cast->mesh : nullptr);
    for (const Variant& other : project.others)
        add(other.cast ? other.cast->mesh : nullptr);
    return hash;
}

} // namespace moldwright::test
