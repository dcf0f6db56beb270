// SPDX-License-Identifier: AGPL-3.0-or-later
// The options of pouring: how the mold leans, and its overflows.
#include "cli/mold_options.h"
#include "cli/option_values.h"

#include <charconv>

namespace moldwright::cli {

void MoldOptions::declarePouring(CLI::App& app) {
    app.add_option("--pour-tilt", pourTilt,
                   "How far the mold's top leans while it is filled, 0 to 30; auto: as the least air stays")
        ->type_name("DEG|auto");
    app.add_option("--pour-towards", pourTowards,
                   "Which way: 0 to the right, 90 to half 1, or to the back of a mold that lies flat")
        ->type_name("DEG");
    app.add_option("--overflow", overflows,
                   "Closed wells beside each solid of each cavity, for the material that arrives last")
        ->type_name("N")
        ->check(fromTo(0, 12));
    length(app, "--overflow-diameter", overflowDiameter, "Of the wells in the parting plane");
    length(app, "--overflow-channel", overflowChannel,
           "Width of the channel that leads there; 0.3 of the well's at most");
    length(app, "--overflow-length", overflowLength, "Of that channel, from the cavity to the well");
}

Result<void> MoldOptions::applyPouring(MoldSettings& settings) const {
    take(settings.overflows.count, overflows);
    take(settings.overflows.diameter, overflowDiameter);
    take(settings.overflows.channel, overflowChannel);
    take(settings.overflows.length, overflowLength);
    PourTilt& tilt = settings.spout.tilt;
    take(tilt.towards, pourTowards);
    if (pourTilt.empty())
        return {};
    tilt.automatic = pourTilt == "auto";
    if (tilt.automatic)
        return {};
    const char* end = pourTilt.data() + pourTilt.size();
    const auto read = std::from_chars(pourTilt.data(), end, tilt.degrees);
    if (read.ec != std::errc() || read.ptr != end)
        return failure(ErrorCode::Usage, MW_TEXT("cli", "--pour-tilt takes degrees, or auto."));
    return {};
}

} // namespace moldwright::cli
