// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/action_table.h"

#include "window/action_menus.h"

namespace moldwright {

std::vector<ActionMenus::Menu> ActionMenus::all() {
    return {
        {QT_TR_NOOP("&File"), file()},     {QT_TR_NOOP("&Edit"), edit()},   {QT_TR_NOOP("&View"), view()},
        {QT_TR_NOOP("&Part"), part()},     {QT_TR_NOOP("P&lane"), plane()}, {QT_TR_NOOP("&Guides"), guides()},
        {QT_TR_NOOP("&Deform"), deform()}, {QT_TR_NOOP("&Mold"), mold()},   {QT_TR_NOOP("&Report"), report()},
        {QT_TR_NOOP("&Window"), window()}, {QT_TR_NOOP("&Help"), help()},
    };
}

std::span<const ActionSpec> actionTable() {
    static const std::vector<ActionSpec> table = [] {
        std::vector<ActionSpec> commands;
        for (const ActionMenus::Menu& menu : ActionMenus::all())
            for (ActionSpec command : menu.commands) {
                command.menu = menu.title;
                commands.push_back(command);
            }
        return commands;
    }();
    return table;
}

} // namespace moldwright
