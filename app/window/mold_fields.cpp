// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/mold_fields.h"

#include "mold/pour_tilt.h"
#include "project/cavity_places.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <type_traits>
#include <utility>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(MoldPages)
};

NumberProperty millimetres(double least, double most, bool slider = false) {
    return {u"mm"_s, least, most, 0.5, 1, slider};
}

/// A field for one number, found by `place` in settings to be read and in settings to be written.
template <class Place>
MoldField numberField(const QString& id, const QString& label, const QString& help, NumberProperty kind,
                      Place place) {
    return {{id, label, help, std::move(kind)},
            [place](const MoldSettings& mold) { return static_cast<double>(place(mold)); },
            [place](MoldSettings& mold, const QVariant& value) {
                auto& number = place(mold);
                number = static_cast<std::remove_reference_t<decltype(number)>>(value.toDouble());
            }};
}

template <class Place>
MoldField countField(const QString& id, const QString& label, const QString& help, int most, Place place) {
    return numberField(id, label, help, NumberProperty{{}, 0, static_cast<double>(most), 1, 0, false}, place);
}

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
         {{u"block-shape"_s, Words::tr("Outline"),
           Words::tr(
               "A box, or a shell that saves material: what holds nothing is cut away from its corners."),
           ChoiceProperty{{Words::tr("Box"), Words::tr("Shell")}}},
          [](const MoldSettings& mold) { return static_cast<double>(mold.shape); },
          [](MoldSettings& mold, const QVariant& value) {
              mold.shape = static_cast<BlockShape>(value.toInt());
          }},
         numberField(
             u"outer-draft"_s, Words::tr("Outer draft"),
             Words::tr("The outer faces widen to the back by this, so that a half that is cast leaves "
                       "its form; below 0 they narrow."),
             {u"°"_s, -15, 15, 0.5, 1, false}, [](auto& mold) -> auto& { return mold.outerDraft; })}};
}

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
                         [](auto& mold) -> auto& { return mold.machines.clamp; })}};
}

MoldFieldSection cavityFields() {
    const NumberProperty upTo{{}, 1, 12, 1, 0, false};
    const NumberProperty shrinkRange{u"%"_s, -5, 20, 0.1, 2, false};
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
                     [](auto& mold) -> auto& { return mold.layout.spacing; }),
         {{u"shrink"_s, Words::tr("Shrink"),
           Words::tr("By how much the material shrinks; the cavity is made larger by it. The same along "
                     "all axes of the part until y or z differ, then along x. Less than 0: it expands."),
           shrinkRange},
          [](const MoldSettings& mold) { return mold.shrink.percent.x(); },
          [](MoldSettings& mold, const QVariant& value) {
              Eigen::Vector3d& percent = mold.shrink.percent;
              const bool asOne = percent.y() == percent.x() && percent.z() == percent.x();
              percent = asOne ? Eigen::Vector3d::Constant(value.toDouble())
                              : Eigen::Vector3d(value.toDouble(), percent.y(), percent.z());
          }},
         numberField(u"shrink-y"_s, Words::tr("Along y"), Words::tr("Shrink along y of the part."),
                     shrinkRange, [](auto& mold) -> auto& { return mold.shrink.percent.y(); }),
         numberField(u"shrink-z"_s, Words::tr("Along z"), Words::tr("Shrink along z of the part."),
                     shrinkRange, [](auto& mold) -> auto& { return mold.shrink.percent.z(); }),
         {{u"shrink-formula"_s, Words::tr("Made larger by"),
           Words::tr("Both are in use; at 5 % they are 1.0500 and 1.0526. The report says which."),
           ChoiceProperty{{u"1 + S"_s, u"1 / (1 − S)"_s}}},
          [](const MoldSettings& mold) { return static_cast<double>(mold.shrink.formula); },
          [](MoldSettings& mold, const QVariant& value) {
              mold.shrink.formula = value.toInt() == 0 ? ShrinkFormula::Plus : ShrinkFormula::Divide;
          }}}};
}

MoldField tiltChoice() {
    return {
        {u"pour-tilt"_s, Words::tr("Tilted"),
         Words::tr("While it is filled: by number, or as the least air stays. What that would save is told "
                   "when the mold is built."),
         ChoiceProperty{{Words::tr("By number"), Words::tr("Automatic")}}},
        [](const MoldSettings& mold) { return mold.spout.tilt.automatic ? 1.0 : 0.0; },
        [](MoldSettings& mold, const QVariant& value) { mold.spout.tilt.automatic = value.toInt() != 0; }};
}

MoldFieldSection fillingFields() {
    return {
        Words::tr("Filling"),
        {{{u"spout"_s, Words::tr("Spout"),
           Words::tr("In the parting plane for a mold that stands on its edge; through half 1 for one "
                     "that lies flat: that one breaks off at its neck."),
           ChoiceProperty{
               {Words::tr("None"), Words::tr("In the parting plane"), Words::tr("Through half 1")}}},
          [](const MoldSettings& mold) {
              return !mold.spout.on ? 0.0 : mold.spout.resting == Resting::Standing ? 1.0 : 2.0;
          },
          [](MoldSettings& mold, const QVariant& value) {
              mold.spout.on = value.toInt() != 0;
              mold.spout.resting = value.toInt() == 2 ? Resting::Lying : Resting::Standing;
          }},
         {{u"runners"_s, Words::tr("Runners"),
           Words::tr(
               "From a spout in the parting plane to cavities in rows and columns: the shortest, or all "
               "ways equally long, so that the cavities fill together."),
           ChoiceProperty{{Words::tr("Shortest"), Words::tr("Equally long")}}},
          [](const MoldSettings& mold) { return mold.spout.runners == Runners::Balanced ? 1.0 : 0.0; },
          [](MoldSettings& mold, const QVariant& value) {
              mold.spout.runners = value.toInt() != 0 ? Runners::Balanced : Runners::Shortest;
          }},
         numberField(u"spout-diameter"_s, Words::tr("Spout's width"),
                     Words::tr("In the parting plane; of one through half 1, above its neck."),
                     millimetres(2, 60), [](auto& mold) -> auto& { return mold.spout.diameter; }),
         numberField(u"spout-neck"_s, Words::tr("Neck"),
                     Words::tr("Where a spout through half 1 breaks off."), millimetres(1, 30),
                     [](auto& mold) -> auto& { return mold.spout.neck; }),
         tiltChoice(),
         numberField(u"pour-tilt-degrees"_s, Words::tr("Tilt"),
                     Words::tr("How far the mold's top leans while it is filled, where that is by number."),
                     {u"°"_s, 0, mostPourTilt, 1, 0, false},
                     [](auto& mold) -> auto& { return mold.spout.tilt.degrees; }),
         numberField(u"pour-towards"_s, Words::tr("Towards"),
                     Words::tr("0 to the right, 90 to half 1, or to the back of a mold that lies flat."),
                     {u"°"_s, 0, 359, 45, 0, false},
                     [](auto& mold) -> auto& { return mold.spout.tilt.towards; }),
         {{u"vents"_s, Words::tr("Vents"), Words::tr("Where air would stay while the mold is filled."),
           ChoiceProperty{{Words::tr("None"), Words::tr("Automatic")}}},
          [](const MoldSettings& mold) { return mold.vents.on ? 1.0 : 0.0; },
          [](MoldSettings& mold, const QVariant& value) { mold.vents.on = value.toInt() != 0; }},
         numberField(u"vent-depth"_s, Words::tr("Vents' depth"),
                     Words::tr("In the parting plane, both halves together; 0: as their width asks."),
                     {u"mm"_s, 0, 5, 0.01, 3, false}, [](auto& mold) -> auto& { return mold.vents.depth; }),
         countField(u"overflows"_s, Words::tr("Overflows"),
                    Words::tr("Closed wells beside each solid of each cavity, for the material that "
                              "arrives last."),
                    12, [](auto& mold) -> auto& { return mold.overflows.count; }),
         numberField(u"overflow-diameter"_s, Words::tr("Their width"),
                     Words::tr("Of the wells in the parting plane."), millimetres(2, 50),
                     [](auto& mold) -> auto& { return mold.overflows.diameter; }),
         numberField(u"overflow-channel"_s, Words::tr("Their channels' width"),
                     Words::tr("0.3 of the well's at most."), {u"mm"_s, 0.5, 15, 0.1, 2, false},
                     [](auto& mold) -> auto& { return mold.overflows.channel; }),
         numberField(u"overflow-length"_s, Words::tr("Their channels' length"),
                     Words::tr("From the cavity to the well."), millimetres(0.5, 30),
                     [](auto& mold) -> auto& { return mold.overflows.length; }),
         numberField(u"hollow"_s, Words::tr("Cast hollow"),
                     Words::tr("The wall that stays when the rest is poured out again; 0: solid."),
                     millimetres(0, 50), [](auto& mold) -> auto& { return mold.hollow.wall; })}};
}

MoldFieldSection closingFields() {
    return {Words::tr("Closing and opening"),
            {countField(u"keys"_s, Words::tr("Registration keys"),
                        Words::tr("On half 2, in sockets of half 1; one is larger, so that the halves fit "
                                  "one way only."),
                        12, [](auto& mold) -> auto& { return mold.keys.count; }),
             numberField(u"key-clearance"_s, Words::tr("Their clearance"),
                         Words::tr("On all sides and in depth."), {u"mm"_s, 0, 2, 0.05, 2, false},
                         [](auto& mold) -> auto& { return mold.keys.clearance; }),
             countField(u"slits"_s, Words::tr("Wedge slits"),
                        Words::tr("Notches at the edge of the plane, to pry the halves apart."), 8,
                        [](auto& mold) -> auto& { return mold.slits.count; }),
             countField(u"bolts"_s, Words::tr("Bolt holes"), Words::tr("Straight through both halves."), 12,
                        [](auto& mold) -> auto& { return mold.bolts.count; }),
             countField(u"ejectors"_s, Words::tr("Ejector holes"), Words::tr("For each cavity."), 8,
                        [](auto& mold) -> auto& { return mold.ejectors.count; })}};
}

MoldFieldSection pocketFields() {
    const NumberProperty size = millimetres(1, 100);
    return {
        Words::tr("Insert pockets"),
        {countField(u"pockets"_s, Words::tr("Pockets"),
                    Words::tr("In the parting face, for nuts, magnets or dowels."), 12,
                    [](auto& mold) -> auto& { return mold.pockets.count; }),
         {{u"pocket-shape"_s, Words::tr("Insert"), Words::tr("Its shape, seen along the normal."),
           ChoiceProperty{{Words::tr("Round"), Words::tr("Hexagon"), Words::tr("Rectangle")}}},
          [](const MoldSettings& mold) { return static_cast<double>(mold.pockets.shape); },
          [](MoldSettings& mold, const QVariant& value) {
              mold.pockets.shape = static_cast<PocketShape>(value.toInt());
          }},
         numberField(u"pocket-width"_s, Words::tr("Its width"),
                     Words::tr("Diameter, across flats, or the side along y."), size,
                     [](auto& mold) -> auto& { return mold.pockets.width; }),
         numberField(u"pocket-length"_s, Words::tr("Its length"),
                     Words::tr("The side along x, of a rectangle."), size,
                     [](auto& mold) -> auto& { return mold.pockets.length; }),
         numberField(u"pocket-depth"_s, Words::tr("Pockets' depth"), Words::tr("Into the half."), size,
                     [](auto& mold) -> auto& { return mold.pockets.depth; }),
         numberField(u"pocket-clearance"_s, Words::tr("Pockets' clearance"),
                     Words::tr("Round the insert, at the pocket's floor."), {u"mm"_s, 0, 2, 0.05, 2, false},
                     [](auto& mold) -> auto& { return mold.pockets.clearance; }),
         {{u"pocket-half"_s, Words::tr("Pockets in"), Words::tr("Dowels ask for both halves."),
           ChoiceProperty{{Words::tr("Half 1"), Words::tr("Half 2"), Words::tr("Halves 1 and 2")}}},
          [](const MoldSettings& mold) { return mold.pockets.side == 0 ? 2.0 : mold.pockets.side - 1.0; },
          [](MoldSettings& mold, const QVariant& value) { mold.pockets.side = (value.toInt() + 1) % 3; }}}};
}

MoldFieldSection plaqueFields() {
    return {
        Words::tr("Plaque"),
        {{{u"plaque"_s, Words::tr("Letters"),
           Words::tr("Engraved in the back of each half; | between lines. {part}, {half} and {shrink} are "
                     "replaced; auto: all three. Empty: none."),
           TextProperty{u"auto"_s}},
          [](const MoldSettings& mold) { return QString::fromStdString(mold.plaque.text); },
          [](MoldSettings& mold, const QVariant& value) {
              mold.plaque.text = value.toString().toStdString();
          }},
         numberField(u"plaque-height"_s, Words::tr("Letters' height"),
                     Words::tr("Of capitals, 2.8 mm or more; 0: as large as there is room for."),
                     millimetres(0, 100), [](auto& mold) -> auto& { return mold.plaque.height; }),
         numberField(u"plaque-depth"_s, Words::tr("Letters' depth"), Words::tr("Of their grooves."),
                     {u"mm"_s, 0.1, 5, 0.1, 2, false},
                     [](auto& mold) -> auto& { return mold.plaque.depth; })}};
}

} // namespace

std::vector<MoldFieldSection> moldFieldSections() {
    return {blockFields(),  cavityFields(), fillingFields(), closingFields(),
            pocketFields(), plaqueFields(), machineFields()};
}

} // namespace moldwright
