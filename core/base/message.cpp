// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/message.h"

#include <cctype>
#include <cstdio>

namespace moldwright {

std::string Message::fill(const std::string& translated) const {
    std::string out;
    for (std::size_t i = 0; i < translated.size(); ++i) {
        const bool place = translated[i] == '{' && i + 2 < translated.size() && translated[i + 2] == '}' &&
                           std::isdigit(static_cast<unsigned char>(translated[i + 1]));
        if (!place) {
            out += translated[i];
            continue;
        }
        const auto index = static_cast<std::size_t>(translated[i + 1] - '0');
        if (index < arguments.size())
            out += arguments[index];
        i += 2;
    }
    return out;
}

std::string readable(double value, int digits) {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.*g", digits, value);
    return buffer;
}

} // namespace moldwright
