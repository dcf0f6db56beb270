// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/mold_feature_pages.h"

#include "theme/theme.h"
#include "window/action_table.h"
#include "window/mold_fields.h"
#include "window/mold_placing.h"
#include "window/workbench.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(MoldFeaturePages)
};

const QString prefix = u"feature-"_s; ///< then the kind and the number

QString iconOf(Placeable kind) {
    const std::array names = {u"spout"_s, u"vent"_s,    u"key"_s,      u"slit"_s,
                              u"bolt"_s,  u"ejector"_s, u"overflow"_s, u"pocket"_s};
    return names.at(static_cast<std::size_t>(kind));
}

const PlacedRow* rowOf(const Workbench& bench, const QString& id) {
    const std::optional<FeatureName> name = featureOf(id);
    return name ? bench.placing().row(name->kind, name->number) : nullptr;
}

/// Whether only its way along an edge of the block can be chosen, and along which axis.
std::optional<int> alongAxis(const PlacedRow& row) {
    if (row.stands.kind == Placeable::Slit)
        return 1;
    const bool throughHalf = row.copies.front()->name != "Spout";
    return row.stands.kind == Placeable::Spout && !throughHalf ? std::optional(0) : std::nullopt;
}

QString steelText(const PlacedRow& row) {
    return row.thinnest == nullptr ? u"–"_s
                                   : u"%1 mm"_s.arg(std::floor(10 * row.thinnest->thickness) / 10, 0, 'f', 1);
}

/// Mold's frame to the scene's.
class ToPart {
public:
    explicit ToPart(const MoldSketch& sketch) : m_moldToPart(sketch.partToMold.inverse()) {}

    [[nodiscard]] Eigen::Vector3d point(const Eigen::Vector2d& p) const {
        return m_moldToPart * Eigen::Vector3d(p.x(), p.y(), 0);
    }
    [[nodiscard]] scene::Outline outline(const PlanShape& shape, const Eigen::Vector2d& by = {0, 0}) const {
        scene::Outline line;
        for (const Eigen::Vector2d& p : shape)
            line.push_back(point(p + by));
        return line;
    }

private:
    Eigen::Isometry3d m_moldToPart;
};

/// How far the settings in view have moved a feature since the newest answer.
Eigen::Vector2d movedBy(const Workbench& bench, const PlacedRow& row) {
    Eigen::Vector2d by = bench.placing().placeInView(row) - row.stands.place;
    if (const auto axis = alongAxis(row))
        by[1 - *axis] = 0;
    return by;
}

/// Where a copy is taken hold of, mold's frame.
Eigen::Vector2d gripOf(const MoldFeature& copy) {
    return copy.stands->place + copy.origin;
}

/// Whether a feature is told of as failing: its steel, or that nothing can be built with it where it is.
bool isFailing(const Workbench& bench, const PlacedRow& row, const QString& selected) {
    const bool refused =
        !bench.placing().refusal().isEmpty() && selected == featureId(row.stands.kind, row.stands.number);
    return row.failing() || refused;
}

} // namespace

QString featureId(Placeable kind, int number) {
    const std::string_view name = placeableNames.at(static_cast<std::size_t>(kind));
    return prefix + QString::fromLatin1(name.data(), static_cast<qsizetype>(name.size())) + u'-' +
           QString::number(number);
}

std::optional<FeatureName> featureOf(const QString& id) {
    if (!id.startsWith(prefix))
        return std::nullopt;
    const QStringList parts = id.mid(prefix.size()).split(u'-');
    const auto kind = std::ranges::find(placeableNames, parts.front().toStdString());
    if (parts.size() != 2 || kind == placeableNames.end())
        return std::nullopt;
    return FeatureName{static_cast<Placeable>(kind - placeableNames.begin()), parts.back().toInt()};
}

void addFeatureRows(std::vector<ProjectRow>& rows, int parent, const Workbench& bench) {
    for (const PlacedRow& row : bench.placing().rows()) {
        const QString id = featureId(row.stands.kind, row.stands.number);
        ProjectRow added{.id = id,
                         .parent = parent,
                         .iconName = iconOf(row.stands.kind),
                         .name = featureName(row.stands.kind, row.stands.number),
                         .value = steelText(row)};
        if (row.failing())
            added.tint = toColor(theme().scene.errorInk);
        rows.push_back(std::move(added));
    }
}

PropertyPage featurePage(const QString& id, const Workbench& bench, const Actions& actions) {
    const PlacedRow* row = rowOf(bench, id);
    const FeatureName name = *featureOf(id);
    PropertyPage page{id,
                      iconOf(name.kind),
                      featureName(name.kind, name.number),
                      Words::tr("Drag its disc in the view, or type here."),
                      {}};
    const NumberProperty place{u"mm"_s, -10000, 10000, 0.5, 2, false};
    PropertySection where{Words::tr("Place in the parting plane"),
                          {},
                          {actions[u"place-automatically"_s], actions[u"place-all-automatically"_s]},
                          false};
    const std::optional<int> along = row != nullptr ? alongAxis(*row) : std::nullopt;
    if (name.kind == Placeable::Slit)
        where.rows.push_back({u"feature-side"_s, Words::tr("Face"),
                              Words::tr("Of the block, seen from half 1."),
                              ChoiceProperty{{Words::tr("Left"), Words::tr("Right")}}});
    if (along)
        where.rows.push_back({*along == 0 ? u"feature-x"_s : u"feature-y"_s, Words::tr("Along the edge"),
                              Words::tr("From the middle of the mold."), place});
    else
        for (const auto& [field, label] : {std::pair{u"feature-x"_s, u"X"_s}, {u"feature-y"_s, u"Y"_s}})
            where.rows.push_back(
                {field, label,
                 name.kind == Placeable::Key || name.kind == Placeable::Bolt || name.kind == Placeable::Pocket
                     ? Words::tr("From the middle of the mold; up is where it is filled.")
                     : Words::tr("From the middle of its cavity; up is where it is filled."),
                 place});
    page.layout = u"%1"_s.arg(along.value_or(-1));
    PropertySection sizes = sectionOf(fieldsOfKind(name.kind));
    sizes.title = Words::tr("All: %1").arg(sizes.title);
    page.sections = {std::move(where),
                     std::move(sizes),
                     {Words::tr("Measured"),
                      {{u"feature-stands"_s, Words::tr("Stands"), {}, ReadingProperty{}},
                       {u"feature-steel"_s, Words::tr("Smallest steel"),
                        Words::tr("Between this and the nearest other feature or face of the block."),
                        ReadingProperty{true}}},
                      {},
                      false}};
    return page;
}

void fillFeaturePage(PropertyPanel& panel, const Workbench& bench) {
    const PlacedRow* row = rowOf(bench, panel.pageId());
    if (row == nullptr)
        return;
    fillFields(panel, fieldsOfKind(row->stands.kind), bench.project().mold);
    const Eigen::Vector2d place = bench.placing().placeInView(*row);
    panel.setValue(u"feature-x"_s, place.x());
    panel.setValue(u"feature-y"_s, place.y());
    panel.setValue(u"feature-side"_s, place.x() < 0 ? 0 : 1);
    const auto byHand = placeByHand(bench.project().mold.placed, row->stands.kind, row->stands.number);
    panel.setValue(u"feature-stands"_s,
                   QStringList{byHand ? Words::tr("by hand") : Words::tr("automatically"), {}});
    panel.setValue(u"feature-steel"_s, QStringList{steelText(*row), u"≥ %1 mm"_s.arg(row->asked, 0, 'g', 3)});
    panel.setMissesGoal(u"feature-steel"_s, row->failing());
}

bool applyFeatureValue(Workbench& bench, const QString& id, const QString& page, double value, bool preview) {
    const PlacedRow* row = rowOf(bench, page);
    if (row == nullptr || !id.startsWith(prefix))
        return false;
    PlacedFeature feature = row->stands;
    feature.place = placeByHand(bench.document().committed().mold.placed, feature.kind, feature.number)
                        .value_or(row->stands.place);
    if (id == u"feature-side"_s)
        feature.place.x() = (value == 0 ? -1 : 1) * std::max(1.0, std::abs(feature.place.x()));
    else
        feature.place[id == u"feature-x"_s ? 0 : 1] = value;
    bench.placing().place(feature, page + id, preview);
    return true;
}

scene::ShownPlan shownPlan(const Workbench& bench, const QString& selected) {
    scene::ShownPlan plan;
    const MoldSketch* sketch = bench.placing().sketch();
    if (sketch == nullptr)
        return plan;
    const ToPart part(*sketch);
    plan.lines.push_back(part.outline(sketch->block.body.base));
    for (const PlanShape& line : sketch->partingLines)
        plan.lines.push_back(part.outline(line));
    for (const PlacedRow& row : bench.placing().rows()) {
        const Eigen::Vector2d by = movedBy(bench, row);
        const bool byHand =
            placeByHand(bench.project().mold.placed, row.stands.kind, row.stands.number).has_value();
        scene::ShownFeature shown{{},
                                  {},
                                  byHand,
                                  isFailing(bench, row, selected),
                                  selected == featureId(row.stands.kind, row.stands.number)};
        for (const MoldFeature* copy : row.copies) {
            shown.outlines.push_back(part.outline(copy->outline, by));
            shown.places.push_back(part.point(gripOf(*copy) + by));
        }
        plan.features.push_back(std::move(shown));
    }
    return plan;
}

std::vector<scene::Chip> featureChips(const Workbench& bench, const QString& selected) {
    std::vector<scene::Chip> chips;
    const MoldSketch* sketch = bench.placing().sketch();
    if (sketch == nullptr)
        return chips;
    const ToPart part(*sketch);
    const QString refusal = bench.placing().refusal();
    for (const PlacedRow& row : bench.placing().rows()) {
        const bool chosen = selected == featureId(row.stands.kind, row.stands.number);
        if (!chosen && !row.failing())
            continue;
        const bool failing = isFailing(bench, row, selected);
        const QString words = chosen && !refusal.isEmpty() ? refusal.section(u". "_s, 0, 0) : steelWords(row);
        chips.push_back(
            {part.point(gripOf(*row.copies.front()) + movedBy(bench, row)),
             {{},
              {{std::nullopt,
                {{featureName(row.stands.kind, row.stands.number).toStdString(), scene::Ink::Text, chosen},
                 {words.toStdString(), failing ? scene::Ink::Error : scene::Ink::Text, chosen}},
                {}}}}});
    }
    return chips;
}

} // namespace moldwright
