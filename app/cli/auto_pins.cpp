// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/auto_pins.h"

#include "design/given_up.h"
#include "pins/suggested_pins.h"

namespace moldwright::cli {

namespace {

/// Ends of limbs that are worth pinning in a mold state.
Result<std::vector<Pin>> tipsAt(const MoldState& state, const DesignRequest& request, const Task& task) {
    Result<PinSuggestions> suggested = suggestPins(*request.part, {.seed = request.seed}, task);
    if (!suggested)
        return std::unexpected(suggested.error());
    rankPins(*suggested, *request.part, state, request.draftDegrees);
    std::vector<Pin> tips;
    for (const SuggestedPin& pin : suggested->pins)
        if (pin.kind == PinKind::Tip && pin.gain > 0)
            tips.push_back({pin.point});
    return tips;
}

bool noWorse(const DesignResult& pinned, const DesignResult& plain) {
    return pinned.castable && (!plain.castable || givenUp(pinned) <= givenUp(plain));
}

} // namespace

Result<AutoPinned> designWithTips(const DesignRequest& request, const Task& task, const FrameSink& frames) {
    Result<DesignResult> plain = design(request, task.part(0, 0.5), frames);
    if (!plain || plain->cutShort)
        return plain ? Result<AutoPinned>({request, std::move(*plain)}) : std::unexpected(plain.error());
    AutoPinned kept{request, std::move(*plain)};
    DesignRequest asked = request;
    asked.plane = kept.result.state.plane;
    Result<std::vector<Pin>> tips = tipsAt(kept.result.state, request, task.part(0.5, 0.55));
    if (!tips || tips->empty())
        return kept;
    asked.pins = std::move(*tips);
    Result<DesignResult> pinned = design(asked, task.part(0.55, 1), frames);
    if (pinned && !pinned->cutShort && noWorse(*pinned, kept.result))
        kept = {std::move(asked), std::move(*pinned)};
    return kept;
}

} // namespace moldwright::cli
