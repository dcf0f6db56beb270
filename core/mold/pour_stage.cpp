// SPDX-License-Identifier: AGPL-3.0-or-later
// The builder's stage that finds how the mold leans while it is filled.
#include "mold/mold_builder.h"

namespace moldwright {

/// What stays by the stages that will build the mold, of a copy without what no air depends on.
Result<double> MoldBuilder::airWhenLeaning(const PourTilt& tilt) const {
    MoldBuilder trial = *this;
    trial.m_tilt = tilt;
    trial.m_tellsAir = true;
    MoldSettings& settings = trial.m_mold.settings;
    settings.placed.clear();
    settings.keys.count = settings.slits.count = settings.bolts.count = settings.ejectors.count = 0;
    settings.overflows.count = 0;
    settings.stock.clear();
    Result<void> done;
    for (Result<void> (MoldBuilder::*work)() :
         {&MoldBuilder::layOut, &MoldBuilder::findEntries, &MoldBuilder::findOverflows,
          &MoldBuilder::fitBlock, &MoldBuilder::planJoints})
        if (done)
            done = (trial.*work)();
    if (!done)
        return std::unexpected(done.error());
    double air = 0;
    for (const CavityCopy& copy : trial.m_layout.copies) {
        for (const RemainingAir& remaining : trial.m_joined[copy.kind].remaining)
            air += remaining.volume;
        for (const AirTrap& trap : (*trial.m_entries)[copy.kind].unvented)
            air += trap.volume;
    }
    return air;
}

std::optional<LeaningMold> MoldBuilder::bestLean() const {
    const auto air = [this](const PourTilt& tilt) { return airWhenLeaning(tilt); };
    const double negligible = m_mold.settings.vents.smallestTrap;
    const Result<double> upright = air({});
    if (!upright || *upright <= negligible)
        return std::nullopt;
    const std::optional<TiltFound> best = leastAirTilt(air, negligible);
    constexpr double worthwhile = 0.9; // of the air upright
    if (!best || best->tilt.degrees == 0 || best->air > worthwhile * *upright)
        return std::nullopt;
    return LeaningMold{best->tilt.degrees, best->tilt.towards, *upright, best->air, false};
}

Result<void> MoldBuilder::findTilt() {
    const PourTilt& asked = spout().tilt;
    if (!(asked.degrees >= 0 && asked.degrees <= mostPourTilt))
        return failure(
            ErrorCode::Usage,
            MW_TEXT("Mold", "A mold cannot lean by {0}° while it is filled: 0 to {1}° are possible."),
            {readable(asked.degrees), readable(mostPourTilt)});
    if (!spout().on)
        return {};
    if (!asked.automatic)
        m_tilt = asked;
    else if (const std::optional<LeaningMold> best = bestLean()) {
        m_mold.leaning = best;
        m_tilt = {false, best->degrees, best->towards};
    }
    return {};
}

Result<void> MoldBuilder::tellOfTilt() {
    std::optional<LeaningMold>& lean = m_mold.leaning;
    if (!spout().on)
        return {};
    if (!spout().tilt.automatic && m_tilt.degrees > 0) {
        const Result<double> upright = airWhenLeaning({});
        const Result<double> air = airWhenLeaning(m_tilt);
        if (upright && air)
            lean = LeaningMold{m_tilt.degrees, m_tilt.towards, *upright, *air, false};
    } else if (!spout().tilt.automatic && m_mold.settings.vents.on) {
        lean = bestLean();
    }
    if (!lean)
        return {};
    lean->applied = m_tilt.degrees > 0;
    m_mold.notes.push_back(
        {lean->applied
             ? MW_TEXT(
                   "Mold",
                   "While it is filled the mold is tilted by {0}° towards {1}: {2} mm³ of air stay instead "
                   "of {3}.")
             : MW_TEXT("Mold",
                       "Tilt the mold by {0}° towards {1} while it is filled: trapped air falls from {3} to "
                       "{2} mm³."),
         {readable(lean->degrees, 3),
          leaningWords(lying() ? Resting::Lying : Resting::Standing, lean->towards), readable(lean->air, 3),
          readable(lean->airUpright, 3)}});
    return {};
}

} // namespace moldwright
