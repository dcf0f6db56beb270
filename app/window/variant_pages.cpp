// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/variant_pages.h"

#include "project/variants.h"
#include "theme/theme.h"
#include "window/action_table.h"
#include "window/presentation.h"
#include "window/row_id.h"
#include "window/workbench.h"

#include <QCoreApplication>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(VariantPages)
};

int countOf(const Workbench& bench) {
    return static_cast<int>(variantCount(bench.document().committed()));
}

const Variant& variantOf(const Workbench& bench, int number) {
    return variantAt(bench.document().committed(), static_cast<std::size_t>(number));
}

QString nameOf(const Variant& variant) {
    return QString::fromStdString(variant.variantName);
}

const VariantFigures* figuresOf(const Workbench& bench, int number) {
    return bench.variants().figures(static_cast<std::size_t>(number));
}

bool isCurrent(const Workbench& bench, int number) {
    return number == static_cast<int>(bench.document().committed().place);
}

QString resultOf(const Workbench& bench, int number) {
    if (!variantOf(bench, number).cast)
        return Words::tr("not run");
    const VariantFigures* figures = figuresOf(bench, number);
    return !figures            ? u"…"_s
           : figures->castable ? draftText(figures->worstDraftDegrees)
                               : Words::tr("not castable");
}

/// How a variant stands, in a word.
QString standingOf(const Workbench& bench, int number) {
    const QString result = resultOf(bench, number);
    return isCurrent(bench, number) ? Words::tr("current, %1").arg(result) : result;
}

QStringList rowNames() {
    return {Words::tr("Castable"),     Words::tr("Worst draft"), Words::tr("Strain"),
            Words::tr("Farthest, mm"), Words::tr("RMS, mm"),     Words::tr("Filled, cm³"),
            Words::tr("Block, mm"),    Words::tr("Steps")};
}

QString fixed(double value, int decimals) {
    return QString::number(value, 'f', decimals);
}

QStringList cells(const VariantFigures& figures) {
    const QString none = u"–"_s;
    const auto& block = figures.blockSize;
    return {figures.castable ? Words::tr("yes") : Words::tr("no"),
            draftText(figures.worstDraftDegrees),
            figures.strain ? percentText(*figures.strain) : none,
            fixed(figures.largestDistance, 2),
            figures.rmsDistance ? fixed(*figures.rmsDistance, 2) : none,
            fixed(figures.filledVolume / 1000, 2),
            block ? u"%1×%2×%3"_s.arg(fixed(block->x(), 0), fixed(block->y(), 0), fixed(block->z(), 0))
                  : none,
            figures.steps > 0 ? QString::number(figures.steps) : none};
}

FigureColumn columnOf(const Workbench& bench, int number) {
    const Variant& variant = variantOf(bench, number);
    FigureColumn column{nameOf(variant), isCurrent(bench, number), {}, -1};
    if (const VariantFigures* figures = figuresOf(bench, number)) {
        column.figures = cells(*figures);
        column.failing = figures->castable ? -1 : 0;
        return column;
    }
    column.figures = {variant.cast ? u"…"_s : Words::tr("not run")};
    while (column.figures.size() < rowNames().size())
        column.figures << u"–"_s;
    return column;
}

} // namespace

QString variantId(int number) {
    return u"variant-%1"_s.arg(number);
}

int variantNumber(const QString& id) {
    return numberAfter(u"variant-"_s, id);
}

QString allVariantsId() {
    return u"variants"_s;
}

bool variantsChosen(const QString& selected) {
    return selected == allVariantsId() || variantNumber(selected) >= 0;
}

int variantMeant(const QString& selected, const Workbench& bench) {
    const int number = variantNumber(selected);
    return number >= 0 && number < countOf(bench) ? number
                                                  : static_cast<int>(bench.document().committed().place);
}

void addVariantRows(std::vector<ProjectRow>& rows, const Workbench& bench) {
    const int count = countOf(bench);
    rows.push_back({.id = allVariantsId(),
                    .iconName = u"variants"_s,
                    .name = Words::tr("Variants"),
                    .value = count > 1 ? QString::number(count) : Words::tr("one"),
                    .strong = true});
    if (count == 1)
        return;
    const int parent = static_cast<int>(rows.size()) - 1;
    for (int i = 0; i < count; ++i)
        rows.push_back({.id = variantId(i),
                        .parent = parent,
                        .iconName = u"result"_s,
                        .tint = isCurrent(bench, i) ? std::optional(theme().palette.color(QPalette::Link))
                                                    : std::nullopt,
                        .name = nameOf(variantOf(bench, i)),
                        .value = standingOf(bench, i),
                        .strong = isCurrent(bench, i),
                        .renamable = true});
}

PropertyPage variantPage(const Workbench& bench, const Actions& actions) {
    const int count = countOf(bench);
    PropertyPage page{allVariantsId(),
                      u"variants"_s,
                      Words::tr("Variants"),
                      Words::tr("Several designs of this part in one project."),
                      {}};
    page.layout = count > 1 ? u"several"_s : QString();
    PropertySection table{Words::tr("Side by side"),
                          {Property{u"variants"_s, Words::tr("Variants"), {}, TableProperty{rowNames()}}},
                          {actions[u"choose-variant"_s], actions[u"compare-variants"_s]},
                          true};
    table.notes = {Words::tr("Distances are to the part, after the best rigid fit; the bold one is the "
                             "current one, which all other pages show.")};
    PropertySection edits{{},
                          {},
                          {actions[u"duplicate-variant"_s], actions[u"new-variant"_s], actions[u"rename"_s],
                           actions[u"remove-guide"_s]},
                          count == 1};
    if (count == 1) {
        table.buttons.clear();
        table.notes = {Words::tr("One design so far. Duplicate it to try another plane, other pins or "
                                 "weights, and to compare both.")};
        edits.buttons.resize(2);
    }
    page.sections = {std::move(table), std::move(edits)};
    return page;
}

void fillVariantPage(PropertyPanel& panel, const QString& selected, const Workbench& bench) {
    if (panel.pageId() != allVariantsId())
        return;
    std::vector<FigureColumn> columns;
    for (int i = 0; i < countOf(bench); ++i)
        columns.push_back(columnOf(bench, i));
    panel.setColumns(u"variants"_s, columns, variantMeant(selected, bench));
}

} // namespace moldwright
