// SPDX-License-Identifier: AGPL-3.0-or-later
#include "exchange/user_folder.h"

#include <cstdlib>

namespace moldwright {

std::optional<std::filesystem::path> userFolder(const std::string& kind) {
    const char* config = std::getenv("XDG_CONFIG_HOME");
    const char* home = std::getenv("HOME");
    if (config != nullptr && *config != '\0')
        return std::filesystem::path(config) / "moldwright" / kind;
    if (home != nullptr && *home != '\0')
        return std::filesystem::path(home) / ".config" / "moldwright" / kind;
    return std::nullopt;
}

} // namespace moldwright
