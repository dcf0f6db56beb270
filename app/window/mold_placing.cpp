// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/mold_placing.h"

#include "project/edits.h"
#include "project/title.h"
#include "project/variants.h"
#include "window/document.h"
#include "window/sentence.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace moldwright {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(MoldPlacing)
};

/// What steel is measured to, within a sentence.
QString otherName(const std::string& name, int number) {
    const QString which = number > 0 ? QString::number(number) : QString();
    const auto with = [&](const QString& words) { return words.arg(which).trimmed(); };
    if (name == "outside")
        return Words::tr("the block's face");
    if (name == "Cavity")
        return with(Words::tr("cavity %1"));
    if (name == "Runner")
        return Words::tr("a runner");
    if (name == "Gate")
        return Words::tr("a gate");
    if (name == "Spout")
        return with(Words::tr("spout %1"));
    if (name == "Vent")
        return with(Words::tr("vent %1"));
    if (name == "Key")
        return with(Words::tr("key %1"));
    if (name == "Slit")
        return with(Words::tr("wedge slit %1"));
    if (name == "Bolt hole")
        return with(Words::tr("bolt hole %1"));
    if (name == "Overflow")
        return with(Words::tr("overflow %1"));
    if (name == "Overflow's channel")
        return with(Words::tr("the channel of overflow %1"));
    if (name == "Pocket")
        return with(Words::tr("insert pocket %1"));
    if (name == "Plaque")
        return with(Words::tr("the plaque on half %1"));
    return with(Words::tr("ejector hole %1"));
}

} // namespace

MoldPlacing::MoldPlacing(Document& document, QObject* parent) : QObject(parent), m_document(document) {
    connect(&m_live, &LiveSketch::answered, this, &MoldPlacing::take);
}

void MoldPlacing::setWanted(bool wanted) {
    m_wanted = wanted;
    follow();
}

void MoldPlacing::follow() {
    const Project& project = m_document.project();
    if (!project.cast) {
        m_asked = {};
        m_newest.reset();
        m_good.reset();
        m_rows.clear();
        return;
    }
    const SketchRequest request{trayOf(project, project.name), project.cast->draftDegrees,
                                moldAsBuilt(project)};
    if (!m_wanted || request == m_asked)
        return;
    if (request.tray != m_asked.tray) {
        m_good.reset();
        m_rows.clear();
    }
    m_asked = request;
    m_live.ask(request);
}

void MoldPlacing::take(const std::shared_ptr<const SketchAnswer>& answer) {
    if (answer->request.tray != m_asked.tray)
        return; // of a cast that is gone
    m_newest = answer;
    if (answer->sketch) {
        m_good = answer;
        listRows();
    }
    Q_EMIT changed();
}

const MoldSketch* MoldPlacing::sketch() const {
    return m_good ? &*m_good->sketch : nullptr;
}

QString MoldPlacing::refusal() const {
    return m_newest && !m_newest->sketch && m_newest->request == m_asked
               ? sentence(m_newest->sketch.error().message)
               : QString();
}

void MoldPlacing::listRows() {
    m_rows.clear();
    const MoldSketch& sketch = *m_good->sketch;
    for (const MoldFeature& feature : sketch.features) {
        if (!feature.stands)
            continue;
        const auto same = std::ranges::find_if(m_rows, [&](const PlacedRow& row) {
            return row.stands.kind == feature.stands->kind && row.stands.number == feature.stands->number;
        });
        if (same != m_rows.end()) {
            same->copies.push_back(&feature);
            continue;
        }
        PlacedRow row{*feature.stands, feature.byHand, {&feature}, nullptr, 0};
        row.thinnest = thinnestAbout(sketch.steel, row.stands.kind, row.stands.number);
        if (row.thinnest != nullptr)
            row.asked = steelAsked(*row.thinnest, sketch.settings);
        m_rows.push_back(std::move(row));
    }
    std::ranges::stable_sort(
        m_rows, {}, [](const PlacedRow& row) { return std::pair(row.stands.kind, row.stands.number); });
}

const PlacedRow* MoldPlacing::row(Placeable kind, int number) const {
    const auto found = std::ranges::find_if(
        m_rows, [&](const PlacedRow& row) { return row.stands.kind == kind && row.stands.number == number; });
    return found == m_rows.end() ? nullptr : &*found;
}

Eigen::Vector2d MoldPlacing::placeInView(const PlacedRow& row) const {
    return placeByHand(m_document.project().mold.placed, row.stands.kind, row.stands.number)
        .value_or(row.stands.place);
}

void MoldPlacing::place(const PlacedFeature& feature, const QString& mergeKey, bool preview) {
    const Project& from = m_document.committed();
    MoldSettings mold = from.mold;
    mold.placed = withPlaced(mold.placed, feature);
    const Project after = withMoldSettings(from, mold);
    if (preview)
        m_document.preview(after);
    else
        m_document.edit(Words::tr("Move %1").arg(featureName(feature.kind, feature.number)), after, mergeKey);
}

void MoldPlacing::placeAutomatically(const std::vector<std::pair<Placeable, int>>& features) {
    const Project& from = m_document.committed();
    MoldSettings mold = from.mold;
    for (const auto& [kind, number] : features)
        mold.placed = withoutPlaced(mold.placed, kind, number);
    const auto& [kind, number] = features.front();
    m_document.edit(features.size() == 1 ? Words::tr("Place %1 automatically").arg(featureName(kind, number))
                                         : Words::tr("Place %1 features automatically").arg(features.size()),
                    withMoldSettings(from, mold));
}

void MoldPlacing::placeAllAutomatically() {
    const Project& from = m_document.committed();
    MoldSettings mold = from.mold;
    mold.placed.clear();
    m_document.edit(Words::tr("Place all automatically"), withMoldSettings(from, mold));
}

QString featureName(Placeable kind, int number) {
    const std::array names = {Words::tr("Spout %1"),     Words::tr("Vent %1"),
                              Words::tr("Key %1"),       Words::tr("Wedge slit %1"),
                              Words::tr("Bolt hole %1"), Words::tr("Ejector hole %1"),
                              Words::tr("Overflow %1"),  Words::tr("Insert pocket %1")};
    return names.at(static_cast<std::size_t>(kind)).arg(number + 1);
}

QString steelEnds(const ThinSteel& steel) {
    QString first = otherName(steel.first, steel.firstNumber);
    first[0] = first[0].toUpper();
    const QString second =
        steel.second == "outside" ? Words::tr("block's face") : otherName(steel.second, steel.secondNumber);
    return first + QStringLiteral(" – ") + second;
}

QString steelWords(const PlacedRow& row) {
    if (row.thinnest == nullptr)
        return {};
    const ThinSteel& thin = *row.thinnest;
    const bool first = thin.firstNumber == row.stands.number + 1 && thin.first == steelName(row.stands.kind);
    const QString other =
        first ? otherName(thin.second, thin.secondNumber) : otherName(thin.first, thin.firstNumber);
    if (thin.thickness <= 0)
        return Words::tr("No steel to %1, %2 mm asked for").arg(other).arg(row.asked, 0, 'g', 3);
    const QString thickness = QString::number(std::floor(10 * thin.thickness) / 10, 'f', 1);
    return row.failing() ? Words::tr("%1 mm of steel to %2, %3 asked for")
                               .arg(thickness, other)
                               .arg(row.asked, 0, 'g', 3)
                         : Words::tr("%1 mm of steel to %2").arg(thickness, other);
}

} // namespace moldwright
