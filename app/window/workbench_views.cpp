// SPDX-License-Identifier: AGPL-3.0-or-later
// What the views show, each by its content.
#include "window/workbench.h"

namespace moldwright {

void Workbench::keepPartReady(bool wanted) {
    if (wanted == m_partWanted)
        return;
    m_partWanted = wanted;
    askPart();
}

void Workbench::askPart() {
    const Project& shown = project();
    if (m_partWanted && shown.part && shown.cast)
        m_partAnalysis.ask({shown.part, shown.state, shown.design.draftDegrees, {}});
}

const AnalysisAnswer* Workbench::partAnswer() const {
    // Without a cast the one analysis there is is the part's.
    for (const auto* answer : {m_answer.get(), m_partAnswer.get()})
        if (answer && answer->request.mesh == project().part)
            return answer;
    return nullptr;
}

const Variant& Workbench::variantIn(ViewContent content) const {
    const Variant* other = m_variants.other();
    return content == ViewContent::Compared && other ? *other : project();
}

std::optional<MoldState> Workbench::stateIn(ViewContent content) const {
    const bool compared = content == ViewContent::Compared && m_variants.other();
    return compared ? variantIn(content).state : shownState();
}

ShownSurface Workbench::surface(ViewContent content) const {
    const bool compared = content == ViewContent::Compared && m_variants.other();
    ShownSurface surface;
    surface.variant = &variantIn(content);
    if (!compared && (content != ViewContent::Part || shownMesh() == project().part)) {
        surface.drawn = drawnSurface();
        if (!surface.drawn)
            return surface;
        surface.coarse = analysisIsCoarse();
        surface.analysis = shownAnalysis();
        if (!surface.coarse && m_answer)
            surface.standInAnalysis = &m_answer->standInAnalysis;
        if (m_frame)
            surface.picker = m_frame->picker;
        else if (m_answer)
            surface.picker = m_answer->picker;
        const auto& cast = project().cast;
        if (m_frame)
            surface.before = m_frame->frame.before;
        else if (cast && surface.drawn->mesh == cast->mesh && cast->before.rows() > 0)
            surface.before = {cast, &cast->before};
        return surface;
    }
    const AnalysisAnswer* answer = compared ? m_variants.answer() : partAnswer();
    if (!answer)
        return surface;
    surface.drawn = answer->drawn;
    surface.coarse = answer->coarse;
    surface.analysis = answer->request.state ? &answer->analysis : nullptr;
    surface.standInAnalysis = &answer->standInAnalysis;
    surface.picker = answer->picker;
    return surface;
}

void Workbench::forgetOldMaps() {
    // They hold on to surfaces that nothing else may need any more.
    const Project& shown = project();
    const auto isOld = [&](const SharedMesh& surface) {
        const Variant* other = m_variants.other();
        return surface != shown.part && !(shown.cast && surface == shown.cast->mesh) &&
               !(other && other->cast && surface == other->cast->mesh);
    };
    std::erase_if(m_maps, [&](const auto& map) { return map.second && isOld(map.second->request.surface); });
    std::erase_if(m_asked, [&](const auto& asked) { return isOld(asked.second.surface); });
    if (m_partAnswer && isOld(m_partAnswer->request.mesh))
        m_partAnswer.reset();
}

std::optional<MapRequest> Workbench::mapRequest(ViewContent content, DisplayMode mode) const {
    const ShownSurface shown = surface(content);
    if (!shown.drawn || !isMap(mode) || m_frame)
        return std::nullopt;
    MapRequest request;
    request.mode = mode;
    request.content = content;
    request.surface = shown.drawn->mesh;
    request.standIn = shown.drawn->standIn ? shown.drawn->standIn->mesh : nullptr;
    request.draftDegrees = shown.variant->design.draftDegrees;
    return completeRequest(request, content) ? std::optional(request) : std::nullopt;
}

bool Workbench::completeRequest(MapRequest& request, ViewContent content) const {
    const Variant& variant = variantIn(content);
    if (!needsCast(request.mode)) {
        if (variant.state)
            request.state = *variant.state;
        return variant.state.has_value();
    }
    request.part = project().part;
    request.cast = variant.cast;
    const bool onCast = variant.cast && request.surface == variant.cast->mesh;
    if (request.mode == DisplayMode::Difference) {
        const Variant* other = &variant == &project() ? m_variants.other() : &project();
        request.other = other ? other->cast : nullptr;
        return onCast && request.other;
    }
    const bool known = variant.cast && variant.cast->before.rows() > 0;
    return known && (onCast || request.mode != DisplayMode::Strain);
}

const FaceMap* Workbench::map(ViewContent content, DisplayMode mode) {
    const std::pair key(content, mode);
    const std::optional<MapRequest> request = mapRequest(content, mode);
    if (!request) {
        m_maps.erase(key);
        m_asked.erase(key);
        return nullptr;
    }
    if (const auto asked = m_asked.find(key); asked == m_asked.end() || !(asked->second == *request)) {
        m_asked[key] = *request;
        m_liveMaps.ask(*request);
    }
    const auto& newest = m_maps[key];
    return newest && newest->request.surface == request->surface ? newest.get() : nullptr;
}

} // namespace moldwright
