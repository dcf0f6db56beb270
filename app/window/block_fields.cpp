// SPDX-License-Identifier: AGPL-3.0-or-later
// Block, cavities, shrink, machines: what the mold is about.
#include "window/mold_field_kinds.h"
#include "window/mold_field_tables.h"

#include "project/cavity_places.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(MoldPages)
};

/// The lengths of a stock as a person writes them, and back; what is no length is left out.
QString stockText(const std::vector<double>& stock) {
    QStringList lengths;
    for (const double length : stock)
        lengths += QString::number(length);
    return lengths.join(u", "_s);
}
std::vector<double> stockFrom(const QString& text) {
    std::vector<double> stock;
    for (const QString& word : text.split(QRegularExpression(u"[,;\\s]+"_s), Qt::SkipEmptyParts))
        if (const double length = word.toDouble(); length > 0)
            stock.push_back(length);
    return stock;
}

} // namespace

MoldFieldSection blockFields() {
    const NumberProperty steel = millimetres(1, 25, true);
    return {
        Words::tr("Block"),
        {numberField(u"wall"_s, Words::tr("Wall"),
                     Words::tr("Steel between the cavities and each side face."), steel,
                     [](auto& mold) -> auto& { return mold.wall; }),
         numberField(u"ceiling"_s, Words::tr("Over half 1"), Words::tr("Steel over the cavities of half 1."),
                     steel, [](auto& mold) -> auto& { return mold.ceiling; }),
         numberField(u"floor"_s, Words::tr("Under half 2"), Words::tr("Steel under the cavities of half 2."),
                     steel, [](auto& mold) -> auto& { return mold.floor; }),
         numberField(u"least-steel"_s, Words::tr("Least steel"),
                     Words::tr("Between any two features; what the program places keeps it, and less is "
                               "told of."),
                     millimetres(0.5, 20), [](auto& mold) -> auto& { return mold.leastSteel; }),
         choiceField(u"block-shape"_s, Words::tr("Outline"),
                     Words::tr("A box, or a shell that saves material: what holds nothing is cut away from "
                               "its corners."),
                     {Words::tr("Box"), Words::tr("Shell")}, [](auto& mold) -> auto& { return mold.shape; }),
         numberField(
             u"outer-draft"_s, Words::tr("Outer draft"),
             Words::tr("The outer faces widen to the back by this, so that a half that is cast leaves "
                       "its form; below 0 they narrow."),
             degreesFrom(-15, 15), [](auto& mold) -> auto& { return mold.outerDraft; }),
         numberField(u"size-step"_s, Words::tr("Sizes round up to"),
                     Words::tr("Multiples of this; 0: they are as they come out."), millimetres(0, 50),
                     [](auto& mold) -> auto& { return mold.step; })}};
}

MoldFieldSection cavityFields() {
    const NumberProperty upTo{{}, 1, 12, 1, 0, false};
    return {
        Words::tr("Cavities"),
        {numberField(u"columns"_s, Words::tr("Side by side"), Words::tr("Cavities in a row."), upTo,
                     [](auto& mold) -> auto& { return mold.layout.columns; }),
         numberField(u"rows"_s, Words::tr("Rows"), Words::tr("Rows of cavities."), upTo,
                     [](auto& mold) -> auto& { return mold.layout.rows; }),
         {{u"arrangement"_s, Words::tr("Arrangement"),
           Words::tr("How rows lie to each other. Packed: as close as the outlines allow. Circle: about a "
                     "spout in their middle, each filled over a way of the same length. Free: at the places "
                     "given."),
           ChoiceProperty{{Words::tr("Grid"), Words::tr("Staggered"), Words::tr("Packed"),
                           Words::tr("Circle"), Words::tr("Free")}}},
          [](const MoldSettings& mold) { return static_cast<double>(mold.layout.arrangement); },
          [](MoldSettings& mold, const QVariant& value) {
              mold.layout.arrangement = static_cast<Arrangement>(value.toInt());
              if (mold.layout.arrangement == Arrangement::Free && mold.layout.places.empty())
                  mold.layout.places = {{}};
          }},
         choiceField(
             u"alternation"_s, Words::tr("Every second"),
             Words::tr("Cavity of a row. Turned: about the plane's normal. Turned over: the halves "
                       "swap. Mirrored: the opposite-handed part. What the directions do not allow is "
                       "refused."),
             {Words::tr("The same"), Words::tr("Turned"), Words::tr("Turned over"), Words::tr("Mirrored")},
             [](auto& mold) -> auto& { return mold.layout.alternation; }),
         {{u"places"_s, Words::tr("Places"),
           Words::tr("Of a free layout: x and y of each cavity in mm and how far it is turned in degrees; a "
                     "semicolon between cavities."),
           TextProperty{u"0, 0; 60, 0, 90"_s}},
          [](const MoldSettings& mold) {
              return QString::fromStdString(cavityPlacesText(mold.layout.places));
          },
          [](MoldSettings& mold, const QVariant& value) {
              if (const auto places = cavityPlacesOf(value.toString().toStdString()))
                  mold.layout.places = *places;
          }},
         numberField(u"spacing"_s, Words::tr("Steel between"),
                     Words::tr("Between cavities, and between them and channels."), millimetres(1, 50),
                     [](auto& mold) -> auto& { return mold.layout.spacing; })}};
}

MoldFieldSection shrinkFields() {
    const NumberProperty percent{u"%"_s, -5, 20, 0.1, 2, false};
    const NumberProperty place{u"mm"_s, -10000, 10000, 1, 2, false};
    const auto axis = [](Eigen::Index k) {
        return [k](auto& mold) -> auto& { return mold.shrink.percent[k]; };
    };
    const auto origin = [](Eigen::Index k) {
        return [k](auto& mold) -> auto& { return mold.shrink.origin[k]; };
    };
    const QString stays = Words::tr("Of the point of the part that stays where it is.");
    return {
        Words::tr("Shrink and density"),
        {{{u"shrink"_s, Words::tr("Shrink"),
           Words::tr("By how much the material shrinks; the cavity is made larger by it. The same along "
                     "all axes of the part until y or z differ, then along x. Less than 0: it expands."),
           percent},
          [](const MoldSettings& mold) { return mold.shrink.percent.x(); },
          [](MoldSettings& mold, const QVariant& value) {
              Eigen::Vector3d& along = mold.shrink.percent;
              const bool asOne = along.y() == along.x() && along.z() == along.x();
              along = asOne ? Eigen::Vector3d::Constant(value.toDouble())
                            : Eigen::Vector3d(value.toDouble(), along.y(), along.z());
          }},
         numberField(u"shrink-y"_s, Words::tr("Along y"), Words::tr("Shrink along y of the part."), percent,
                     axis(1)),
         numberField(u"shrink-z"_s, Words::tr("Along z"), Words::tr("Shrink along z of the part."), percent,
                     axis(2)),
         choiceField(u"shrink-formula"_s, Words::tr("Made larger by"),
                     Words::tr("Both are in use; at 5 % they are 1.0500 and 1.0526. The report says which."),
                     {u"1 + S"_s, u"1 / (1 − S)"_s}, [](auto& mold) -> auto& { return mold.shrink.formula; }),
         numberField(u"shrink-origin-x"_s, Words::tr("Origin x"), stays, place, origin(0)),
         numberField(u"shrink-origin-y"_s, Words::tr("Origin y"), stays, place, origin(1)),
         numberField(u"shrink-origin-z"_s, Words::tr("Origin z"), stays, place, origin(2)),
         numberField(u"density"_s, Words::tr("Density"),
                     Words::tr("Of what is cast, for its mass. 0: not known."),
                     {u"g/cm³"_s, 0, 25, 0.1, 3, false}, [](auto& mold) -> auto& { return mold.density; })}};
}

MoldFieldSection machineFields() {
    const auto axis = [](Eigen::Index k) {
        return [k](auto& mold) -> auto& { return mold.machines.bed[k]; };
    };
    const NumberProperty length = millimetres(0, 5000);
    const QString help =
        Words::tr("What the printer can make; a half that is larger is told of. 0: not known.");
    return {Words::tr("Stock and machines"),
            {{{u"stock"_s, Words::tr("Stock"),
               Words::tr("Lengths and widths of blocks that are to be had, in mm, a comma between; the next "
                         "is taken. Empty: any."),
               TextProperty{u"80, 100, 120"_s}},
              [](const MoldSettings& mold) { return stockText(mold.stock); },
              [](MoldSettings& mold, const QVariant& value) { mold.stock = stockFrom(value.toString()); }},
             numberField(u"bed-x"_s, Words::tr("Printer's width"), help, length, axis(0)),
             numberField(u"bed-y"_s, Words::tr("Printer's depth"), help, length, axis(1)),
             numberField(u"bed-z"_s, Words::tr("Printer's height"), help, length, axis(2)),
             numberField(u"press"_s, Words::tr("Press"),
                         Words::tr("What it closes with; a mold that needs more is told of. 0: not known."),
                         {u"kN"_s, 0, 100000, 1, 1, false},
                         [](auto& mold) -> auto& { return mold.machines.clamp; }),
             numberField(u"pressure"_s, Words::tr("Pressure"),
                         Words::tr("In the cavity while it is filled, for the clamp force."),
                         {u"bar"_s, 0, 3000, 1, 1, false}, [](auto& mold) -> auto& { return mold.pressure; }),
             numberField(u"block-density"_s, Words::tr("Block's density"),
                         Words::tr("Of what the halves are made of, for their mass. 0: not known."),
                         {u"g/cm³"_s, 0, 25, 0.1, 2, false},
                         [](auto& mold) -> auto& { return mold.blockDensity; })}};
}

} // namespace moldwright
