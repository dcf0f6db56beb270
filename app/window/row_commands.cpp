// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/row_commands.h"

#include <utility>
#include <vector>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

/// Rows by how their ids begin, those of one thing before those of all of its kind.
const std::vector<std::pair<QString, QStringList>>& rowTable() {
    static const std::vector<std::pair<QString, QStringList>> table = {
        {u"part"_s,
         {u"rename"_s,
          u"hide"_s,
          {},
          u"lay-flat"_s,
          u"turn-by"_s,
          u"turn-x"_s,
          u"turn-y"_s,
          u"turn-z"_s,
          u"centre"_s,
          {},
          u"export-cast"_s}},
        {u"variant"_s,
         {u"choose-variant"_s,
          u"compare-variants"_s,
          {},
          u"duplicate-variant"_s,
          u"new-variant"_s,
          u"rename"_s,
          u"remove-guide"_s}},
        {u"plane"_s,
         {u"best-plane"_s,
          u"next-plane"_s,
          u"suggested-plane"_s,
          {},
          u"plane-x"_s,
          u"plane-y"_s,
          u"plane-z"_s,
          u"plane-on-face"_s,
          u"plane-by-points"_s,
          {},
          u"along-normal"_s,
          u"section"_s,
          u"hide"_s}},
        {u"direction"_s, {u"best-directions"_s, u"normal-directions"_s, {}, u"hide"_s}},
        {u"pin-"_s, {u"rename"_s, u"hide"_s, {}, u"remove-guide"_s}},
        {u"pins"_s,
         {u"pin"_s,
          u"pin-inside"_s,
          u"suggest-pins"_s,
          u"accept-tips"_s,
          {},
          u"import-pins"_s,
          u"export-pins"_s,
          {},
          u"hide"_s,
          u"clear-pins"_s}},
        {u"suggested-pins"_s, {u"suggest-pins"_s, u"accept-tips"_s, {}, u"hide"_s}},
        {u"region-"_s, {u"rename"_s, u"hide"_s, {}, u"paint"_s, u"paint-erase"_s, {}, u"remove-guide"_s}},
        {u"importance"_s,
         {u"new-region"_s,
          u"paint"_s,
          u"paint-crease"_s,
          u"paint-piece"_s,
          u"paint-lasso"_s,
          {},
          u"import-weights"_s,
          u"export-weights"_s,
          {},
          u"hide"_s,
          u"clear-importance"_s}},
        {u"obstruction-"_s, {u"fill-here"_s, u"suggested-plane"_s, u"fill-and-run"_s}},
        {u"undercut"_s, {u"find-undercuts"_s}},
        {u"deform"_s, {u"run"_s, u"fill-and-run"_s, u"find-undercuts"_s, {}, u"restore"_s}},
        {u"cast"_s, {u"show-deviation"_s, u"show-draft"_s, {}, u"export-cast"_s, u"restore"_s}},
        {u"mold"_s,
         {u"build-mold"_s,
          u"open-mold"_s,
          {},
          u"add-part"_s,
          {},
          u"export-mold"_s,
          u"print-report"_s,
          u"hide"_s}},
        {u"tray-"_s, {u"rename"_s, u"read-part-again"_s, {}, u"add-part"_s, u"remove-guide"_s}},
        {u"half-"_s, {u"open-mold"_s, u"export-mold"_s}},
    };
    return table;
}

} // namespace

QStringList commandsOfRow(const QString& row) {
    for (const auto& [beginning, commands] : rowTable())
        if (row.startsWith(beginning))
            return commands;
    return {};
}

} // namespace moldwright
