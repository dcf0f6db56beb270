// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/tray.h"

#include <algorithm>
#include <utility>

namespace moldwright {

Tray trayOf(CertifiedCast cast, std::string name) {
    return {{std::make_shared<const CertifiedCast>(std::move(cast)), std::move(name), {}, 1}};
}

std::string partName(const Tray& tray, std::size_t part) {
    const std::string& name = tray[part].name;
    return name.empty() ? "part " + std::to_string(part + 1) : name;
}

std::string nameAndSource(const Tray& tray, std::size_t part) {
    const std::string& source = tray[part].source;
    return partName(tray, part) + (source.empty() ? "" : " (" + source + ")");
}

std::string namesOf(const Tray& tray) {
    if (tray.size() == 1)
        return tray.front().name;
    std::string names;
    for (std::size_t part = 0; part < tray.size(); ++part)
        names += (part > 0 ? ", " : "") + partName(tray, part);
    return names;
}

Result<SeatedLayout> seated(const Tray& tray, const LayoutSettings& layout) {
    int asked = 0;
    for (std::size_t part = 0; part < tray.size(); ++part) {
        if (tray[part].count < 1 || tray[part].count > mostCavities)
            return failure(
                ErrorCode::Usage,
                MW_TEXT("Mold", "A mold cannot have {0} cavities of {1}: 1 to {2} are possible."),
                {std::to_string(tray[part].count), nameAndSource(tray, part), std::to_string(mostCavities)});
        asked += tray[part].count;
    }
    SeatedLayout seats{layout, {}};
    int places = static_cast<int>(layout.places.size());
    if (layout.arrangement != Arrangement::Free) {
        const int rows = seats.layout.rows;
        seats.layout.columns = std::max(layout.columns, (asked + rows - 1) / rows);
        places = rows * seats.layout.columns;
    } else if (places > 0 && places < asked)
        return failure(ErrorCode::Usage,
                       MW_TEXT("Mold", "The free layout has {0} places; the parts of this mold ask for {1}."),
                       {std::to_string(places), std::to_string(asked)});
    seats.partAt.assign(static_cast<std::size_t>(std::max(0, places - asked)), 0);
    for (std::size_t part = 0; part < tray.size() && places > 0; ++part)
        seats.partAt.insert(seats.partAt.end(), static_cast<std::size_t>(tray[part].count), part);
    return seats;
}

} // namespace moldwright
