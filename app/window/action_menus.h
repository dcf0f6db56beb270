// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "window/action_table.h"

#include <QCoreApplication>

#include <vector>

namespace moldwright {

/// The commands of each menu in its order, without the menu's name; see actionTable().
struct ActionMenus {
    Q_DECLARE_TR_FUNCTIONS(Actions)
public:
    static std::vector<ActionSpec> file();
    static std::vector<ActionSpec> edit();
    static std::vector<ActionSpec> view();
    static std::vector<ActionSpec> part();
    static std::vector<ActionSpec> plane();
    static std::vector<ActionSpec> guides();
    static std::vector<ActionSpec> deform();
    static std::vector<ActionSpec> mold();
    static std::vector<ActionSpec> report();
    static std::vector<ActionSpec> window();
    static std::vector<ActionSpec> help();

    /// The title of each, with its commands, from left to right.
    struct Menu {
        const char* title;
        std::vector<ActionSpec> commands;
    };
    static std::vector<Menu> all();
};

} // namespace moldwright
