// SPDX-License-Identifier: AGPL-3.0-or-later
// Spout, vents, keys, holes, pockets, plaque: what the mold has besides its cavities.
#include "window/mold_field_kinds.h"
#include "window/mold_field_tables.h"

#include "mold/pour_tilt.h"

#include <QCoreApplication>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(MoldPages)
};

const NumberProperty fine{u"mm"_s, 0, 2, 0.05, 2, false}; ///< clearances

std::vector<MoldField> spoutSizes() {
    return {numberField(u"spout-diameter"_s, Words::tr("Spout's width"),
                        Words::tr("In the parting plane; of one through half 1, above its neck."),
                        millimetres(2, 60), [](auto& mold) -> auto& { return mold.spout.diameter; }),
            numberField(u"spout-gate"_s, Words::tr("Gate's width"),
                        Words::tr("Where a channel in the parting plane meets the cavity."),
                        millimetres(1, 60), [](auto& mold) -> auto& { return mold.spout.gate; }),
            numberField(u"spout-funnel"_s, Words::tr("Funnel's width"), Words::tr("At the block's face."),
                        millimetres(2, 100), [](auto& mold) -> auto& { return mold.spout.funnel; }),
            numberField(u"spout-draft"_s, Words::tr("Channels' draft"),
                        Words::tr("Of spouts, runners and gates; more where the directions ask for it."),
                        degreesFrom(0, 30), [](auto& mold) -> auto& { return mold.spout.draft; }),
            numberField(u"spout-neck"_s, Words::tr("Neck"),
                        Words::tr("Where a spout through half 1 breaks off."), millimetres(1, 30),
                        [](auto& mold) -> auto& { return mold.spout.neck; })};
}

std::vector<MoldField> ventSizes() {
    return {numberField(u"vent-diameter"_s, Words::tr("Vents' width"), Words::tr("At the narrowest."),
                        {u"mm"_s, 0.3, 10, 0.1, 2, false},
                        [](auto& mold) -> auto& { return mold.vents.diameter; }),
            numberField(u"vent-depth"_s, Words::tr("Vents' depth"),
                        Words::tr("In the parting plane, both halves together; 0: as their width asks."),
                        {u"mm"_s, 0, 5, 0.01, 3, false},
                        [](auto& mold) -> auto& { return mold.vents.depth; }),
            numberField(u"vent-trap"_s, Words::tr("Air that may stay"),
                        Words::tr("A place where less than this stays gets no vent."),
                        {u"mm³"_s, 0, 10000, 1, 1, false},
                        [](auto& mold) -> auto& { return mold.vents.smallestTrap; })};
}

std::vector<MoldField> keySizes() {
    return {numberField(u"key-diameter"_s, Words::tr("Keys' width"), Words::tr("At the parting plane."),
                        millimetres(2, 60), [](auto& mold) -> auto& { return mold.keys.diameter; }),
            numberField(u"key-height"_s, Words::tr("Keys' height"), Words::tr("Over the parting plane."),
                        millimetres(1, 60), [](auto& mold) -> auto& { return mold.keys.height; }),
            numberField(u"key-clearance"_s, Words::tr("Keys' clearance"),
                        Words::tr("On all sides and in depth."), fine,
                        [](auto& mold) -> auto& { return mold.keys.clearance; }),
            numberField(u"key-draft"_s, Words::tr("Keys' draft"),
                        Words::tr("Against both opening orders; more where the mold's draft is more."),
                        degreesFrom(0, 30), [](auto& mold) -> auto& { return mold.keys.draft; }),
            numberField(u"key-odd"_s, Words::tr("First is larger by"),
                        Words::tr("So that the halves fit one way only."), millimetres(0, 20),
                        [](auto& mold) -> auto& { return mold.keys.oddBy; })};
}

std::vector<MoldField> slitSizes() {
    return {numberField(u"slit-depth"_s, Words::tr("Slits' depth"), Words::tr("Into the block."),
                        millimetres(1, 50), [](auto& mold) -> auto& { return mold.slits.depth; }),
            numberField(u"slit-width"_s, Words::tr("Slits' width"), Words::tr("Along the block's face."),
                        millimetres(2, 100), [](auto& mold) -> auto& { return mold.slits.width; }),
            numberField(u"slit-height"_s, Words::tr("Slits' height"), Words::tr("In each half."),
                        {u"mm"_s, 0.2, 20, 0.1, 2, false},
                        [](auto& mold) -> auto& { return mold.slits.height; })};
}

std::vector<MoldField> boltSizes() {
    return {numberField(u"bolt-diameter"_s, Words::tr("Holes' width"),
                        Words::tr("An M6 bolt passes freely through 6.6 mm."),
                        {u"mm"_s, 1, 60, 0.1, 2, false},
                        [](auto& mold) -> auto& { return mold.bolts.diameter; }),
            numberField(u"bolt-wall"_s, Words::tr("Steel outside"), Words::tr("To the block's faces."),
                        millimetres(1, 50), [](auto& mold) -> auto& { return mold.bolts.wall; }),
            numberField(u"bolt-clear"_s, Words::tr("Steel inside"),
                        Words::tr("To all that stands in the parting plane."), millimetres(1, 50),
                        [](auto& mold) -> auto& { return mold.bolts.clear; })};
}

std::vector<MoldField> ejectorSizes() {
    return {numberField(u"ejector-diameter"_s, Words::tr("Pins' width"), Words::tr("Of the ejector pins."),
                        millimetres(1, 30), [](auto& mold) -> auto& { return mold.ejectors.diameter; }),
            {{u"ejector-half"_s, Words::tr("Pins in"), Words::tr("The half that they pass through."),
              ChoiceProperty{{Words::tr("Half 1"), Words::tr("Half 2")}}},
             [](const MoldSettings& mold) { return mold.ejectors.side - 1.0; },
             [](MoldSettings& mold, const QVariant& value) { mold.ejectors.side = value.toInt() + 1; }}};
}

std::vector<MoldField> overflowSizes() {
    return {numberField(u"overflow-diameter"_s, Words::tr("Wells' width"),
                        Words::tr("Of overflows in the parting plane."), millimetres(2, 50),
                        [](auto& mold) -> auto& { return mold.overflows.diameter; }),
            numberField(u"overflow-channel"_s, Words::tr("Channels' width"),
                        Words::tr("0.3 of the well's at most."), {u"mm"_s, 0.5, 15, 0.1, 2, false},
                        [](auto& mold) -> auto& { return mold.overflows.channel; }),
            numberField(u"overflow-length"_s, Words::tr("Channels' length"),
                        Words::tr("From the cavity to the well."), millimetres(0.5, 30),
                        [](auto& mold) -> auto& { return mold.overflows.length; })};
}

std::vector<MoldField> pocketSizes() {
    const NumberProperty size = millimetres(1, 100);
    return {choiceField(u"pocket-shape"_s, Words::tr("Insert"),
                        Words::tr("Its shape, seen along the normal."),
                        {Words::tr("Round"), Words::tr("Hexagon"), Words::tr("Rectangle")},
                        [](auto& mold) -> auto& { return mold.pockets.shape; }),
            numberField(u"pocket-width"_s, Words::tr("Its width"),
                        Words::tr("Diameter, across flats, or the side along y."), size,
                        [](auto& mold) -> auto& { return mold.pockets.width; }),
            numberField(u"pocket-length"_s, Words::tr("Its length"),
                        Words::tr("The side along x, of a rectangle."), size,
                        [](auto& mold) -> auto& { return mold.pockets.length; }),
            numberField(u"pocket-depth"_s, Words::tr("Pockets' depth"), Words::tr("Into the half."), size,
                        [](auto& mold) -> auto& { return mold.pockets.depth; }),
            numberField(u"pocket-clearance"_s, Words::tr("Pockets' clearance"),
                        Words::tr("Round the insert, at the pocket's floor."), fine,
                        [](auto& mold) -> auto& { return mold.pockets.clearance; }),
            {{u"pocket-half"_s, Words::tr("Pockets in"), Words::tr("Dowels ask for both halves."),
              ChoiceProperty{{Words::tr("Half 1"), Words::tr("Half 2"), Words::tr("Halves 1 and 2")}}},
             [](const MoldSettings& mold) { return mold.pockets.side == 0 ? 2.0 : mold.pockets.side - 1.0; },
             [](MoldSettings& mold, const QVariant& value) { mold.pockets.side = (value.toInt() + 1) % 3; }}};
}

} // namespace

MoldFieldSection fieldsOfKind(Placeable kind) {
    switch (kind) {
    case Placeable::Spout:
        return {Words::tr("Spouts, runners, gates"), spoutSizes()};
    case Placeable::Vent:
        return {Words::tr("Vents"), ventSizes()};
    case Placeable::Key:
        return {Words::tr("Registration keys"), keySizes()};
    case Placeable::Slit:
        return {Words::tr("Wedge slits"), slitSizes()};
    case Placeable::Bolt:
        return {Words::tr("Bolt holes"), boltSizes()};
    case Placeable::Ejector:
        return {Words::tr("Ejector holes"), ejectorSizes()};
    case Placeable::Overflow:
        return {Words::tr("Overflows"), overflowSizes()};
    case Placeable::Pocket:
        return {Words::tr("Insert pockets"), pocketSizes()};
    }
    return {};
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
         choiceField(u"pour"_s, Words::tr("Up while filled"),
                     Words::tr("As a turn of the cast about the plane's normal; automatic: of four the one "
                               "that keeps the least air."),
                     {Words::tr("Automatic"), u"0°"_s, u"90°"_s, u"180°"_s, u"270°"_s},
                     [](auto& mold) -> auto& { return mold.spout.pour; }),
         choiceField(
             u"vents"_s, Words::tr("Vents"), Words::tr("Where air would stay while the mold is filled."),
             {Words::tr("None"), Words::tr("Automatic")}, [](auto& mold) -> auto& { return mold.vents.on; }),
         countField(u"overflows"_s, Words::tr("Overflows"),
                    Words::tr("Closed wells beside each solid of each cavity, for the material that "
                              "arrives last."),
                    12, [](auto& mold) -> auto& { return mold.overflows.count; }),
         numberField(u"hollow"_s, Words::tr("Cast hollow"),
                     Words::tr("The wall that stays when the rest is poured out again; 0: solid."),
                     millimetres(0, 50), [](auto& mold) -> auto& { return mold.hollow.wall; })}};
}

MoldFieldSection tiltFields() {
    return {
        Words::tr("Tilt while filled"),
        {choiceField(
             u"pour-tilt"_s, Words::tr("Tilted"),
             Words::tr("While it is filled: by number, or as the least air stays. What that would save "
                       "is told when the mold is built."),
             {Words::tr("By number"), Words::tr("Automatic")},
             [](auto& mold) -> auto& { return mold.spout.tilt.automatic; }),
         numberField(u"pour-tilt-degrees"_s, Words::tr("Tilt"),
                     Words::tr("How far the mold's top leans while it is filled, where that is by number."),
                     {u"°"_s, 0, mostPourTilt, 1, 0, false},
                     [](auto& mold) -> auto& { return mold.spout.tilt.degrees; }),
         numberField(u"pour-towards"_s, Words::tr("Towards"),
                     Words::tr("0 to the right, 90 to half 1, or to the back of a mold that lies flat."),
                     {u"°"_s, 0, 359, 45, 0, false},
                     [](auto& mold) -> auto& { return mold.spout.tilt.towards; })}};
}

MoldFieldSection closingFields() {
    return {Words::tr("Closing and opening"),
            {countField(u"keys"_s, Words::tr("Registration keys"),
                        Words::tr("On half 2, in sockets of half 1; one is larger, so that the halves fit "
                                  "one way only."),
                        12, [](auto& mold) -> auto& { return mold.keys.count; }),
             countField(u"slits"_s, Words::tr("Wedge slits"),
                        Words::tr("Notches at the edge of the plane, to pry the halves apart."), 8,
                        [](auto& mold) -> auto& { return mold.slits.count; }),
             countField(u"bolts"_s, Words::tr("Bolt holes"), Words::tr("Straight through both halves."), 12,
                        [](auto& mold) -> auto& { return mold.bolts.count; }),
             countField(u"ejectors"_s, Words::tr("Ejector holes"), Words::tr("For each cavity."), 8,
                        [](auto& mold) -> auto& { return mold.ejectors.count; }),
             countField(u"pockets"_s, Words::tr("Insert pockets"),
                        Words::tr("In the parting face, for nuts, magnets or dowels."), 12,
                        [](auto& mold) -> auto& { return mold.pockets.count; })}};
}

MoldFieldSection plaqueFields() {
    return {Words::tr("Plaque"),
            {{{u"plaque"_s, Words::tr("Letters"),
               Words::tr("Engraved in the back of each half; | between lines. {part}, {number}, {revision}, "
                         "{half} and {shrink} are replaced; auto: all there is of them. Empty: none."),
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

} // namespace moldwright
