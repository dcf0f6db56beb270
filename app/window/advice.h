// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "theme/icons.h"

#include <QString>

namespace moldwright {

/// What happened and what to do about it, with the command that does it.
struct Advice {
    Standing standing = Standing::Info;
    QString headline;
    QString text;
    QString action;           ///< id of the command, or empty
    QString otherAction = {}; ///< of a second one
};

} // namespace moldwright
