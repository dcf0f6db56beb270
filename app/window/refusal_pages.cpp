// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/refusal_pages.h"

#include "theme/theme.h"
#include "window/action_table.h"
#include "window/refused_mesh.h"
#include "window/row_id.h"
#include "window/sentence.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(RefusalPages)
};

constexpr int listedAtMost = 200; ///< of all places; more would make no list
constexpr int marksAtOnce = 12;   ///< more would hide the part

QString kindName(FaultKind kind) {
    const std::array names = {Words::tr("Holes"),
                              Words::tr("Crowded edges"),
                              Words::tr("Touching points"),
                              Words::tr("One-sided places"),
                              Words::tr("Faces without area"),
                              Words::tr("Crossings"),
                              Words::tr("Closed surfaces inside")};
    return names.at(static_cast<std::size_t>(kind));
}

QString numberedName(FaultKind kind, int number) {
    const std::array names = {Words::tr("Hole %1"),
                              Words::tr("Crowded edge %1"),
                              Words::tr("Touching point %1"),
                              Words::tr("One-sided place %1"),
                              Words::tr("Face without area %1"),
                              Words::tr("Crossing %1"),
                              Words::tr("Closed surface inside %1")};
    return names.at(static_cast<std::size_t>(kind)).arg(number);
}

int countOf(const RefusedMesh& refused, FaultKind kind) {
    return static_cast<int>(std::ranges::count(refused.places, kind, &FaultPlace::kind));
}

/// "Hole 2": numbered among those of its kind.
QString nameOf(const RefusedMesh& refused, int place) {
    const FaultKind kind = refused.places[static_cast<std::size_t>(place)].kind;
    const auto first = std::ranges::find(refused.places, kind, &FaultPlace::kind) - refused.places.begin();
    return numberedName(kind, place - static_cast<int>(first) + 1);
}

QString sizeText(const FaultPlace& place) {
    const bool edges = place.kind == FaultKind::Hole || place.kind == FaultKind::CrowdedEdge;
    return edges ? Words::tr("%1 edges").arg(place.edges.size())
                 : Words::tr("%1 faces").arg(place.faces.size());
}

/// The gravest of what is wrong, in two words.
QString inShort(const RefusedMesh& refused) {
    if (refused.places.empty())
        return Words::tr("No volume");
    const FaultKind kind = refused.places.front().kind;
    return u"%1: %2"_s.arg(kindName(kind)).arg(countOf(refused, kind));
}

QStringList sentencesOf(const std::vector<Message>& messages) {
    QStringList sentences;
    for (const Message& message : messages)
        sentences << sentence(message);
    return sentences;
}

QStringList faultSentences(const RefusedMesh& refused) {
    QStringList sentences;
    for (const Error& fault : refused.part.faults)
        sentences << sentence(fault.message);
    return sentences;
}

Property reading(const QString& id, const QString& label) {
    return {id, label, {}, ReadingProperty{}};
}

PropertySection waysOut(const Actions& actions) {
    return {
        Words::tr("Ways out"),
        {},
        {actions[u"repair-mesh"_s], actions[u"next-fault"_s], actions[u"read-again"_s], actions[u"open"_s],
         actions[u"copy-diagnosis"_s], actions[u"leave-refused"_s]},
        true,
        {Words::tr("Repair fills holes, splits and drops what too many faces share, and makes faces anew "
                   "where they cross; where that does not help, a closed skin about the surface. Messages "
                   "tell what was done."),
         Words::tr("Or mend the mesh in the program that made it and write the file again; then read it "
                   "again here. What was open before is as it was.")}};
}

PropertyPage faultPage(int number, const RefusedMesh& refused, const Actions& actions) {
    PropertyPage page{faultId(number), u"error"_s, nameOf(refused, number), refused.name, {}};
    page.layout = refused.file;
    page.sections = {
        {Words::tr("Where"),
         {reading(u"fault-place"_s, Words::tr("X, Y, Z")), reading(u"fault-size"_s, Words::tr("Size")),
          reading(u"fault-faces"_s, Words::tr("Faces")), reading(u"fault-edges"_s, Words::tr("Edges"))},
         {},
         false,
         {Words::tr("Lengths are those of the file.")}},
        waysOut(actions)};
    return page;
}

QString threeNumbers(const Eigen::Vector3d& v, const QString& between) {
    QStringList numbers;
    for (const double x : v)
        numbers << QString::number(x, 'g', 5).replace(u'-', QChar(0x2212));
    return numbers.join(between);
}

void fillFault(PropertyPanel& panel, const FaultPlace& place) {
    const auto set = [&](const QString& id, const QString& value) {
        panel.setValue(id, QStringList{value, QString()});
    };
    set(u"fault-place"_s, threeNumbers(place.box.center(), u"  "_s));
    set(u"fault-size"_s, threeNumbers(place.box.sizes(), u" × "_s));
    set(u"fault-faces"_s, QString::number(place.faces.size()));
    set(u"fault-edges"_s, place.edges.empty() ? u"–"_s : QString::number(place.edges.size()));
}

} // namespace

QString refusedId() {
    return u"refused"_s;
}

QString faultId(int place) {
    return u"fault-%1"_s.arg(place);
}

int faultNumber(const QString& id) {
    return numberAfter(u"fault-"_s, id);
}

int listedFaults(const RefusedMesh& refused) {
    return std::min(listedAtMost, static_cast<int>(refused.places.size()));
}

std::array<StepState, stepCount> refusedStates(const RefusedMesh& refused) {
    std::array<StepState, stepCount> states;
    states.fill({Standing::Todo, Words::tr("Needs a sound mesh")});
    states[int(Step::Part)] = {Standing::Failing, inShort(refused)};
    return states;
}

Verdict refusedVerdict(const RefusedMesh& refused) {
    return {Standing::Failing, Words::tr("Cannot be cast yet"), inShort(refused)};
}

std::vector<ProjectRow> refusedRows(const RefusedMesh& refused) {
    std::vector<ProjectRow> rows;
    rows.push_back({.id = refusedId(),
                    .iconName = u"part"_s,
                    .name = refused.name,
                    .value = Words::tr("refused"),
                    .strong = true});
    rows.push_back({.id = u"surface"_s,
                    .parent = 0,
                    .iconName = u"edges"_s,
                    .name = Words::tr("Surface"),
                    .value = Words::tr("%1 faces").arg(refused.drawn->mesh->faceCount())});
    int group = -1;
    for (int i = 0; i < listedFaults(refused); ++i) {
        const FaultPlace& place = refused.places[static_cast<std::size_t>(i)];
        if (i == 0 || place.kind != refused.places[static_cast<std::size_t>(i) - 1].kind) {
            group = static_cast<int>(rows.size());
            rows.push_back({.id = u"faults-%1"_s.arg(static_cast<int>(place.kind)),
                            .parent = 0,
                            .iconName = u"error"_s,
                            .tint = theme().error,
                            .name = kindName(place.kind),
                            .value = QString::number(countOf(refused, place.kind))});
        }
        rows.push_back({.id = faultId(i),
                        .parent = group,
                        .iconName = u"error"_s,
                        .tint = theme().error,
                        .name = nameOf(refused, i),
                        .value = sizeText(place)});
    }
    return rows;
}

PropertyPage refusedPage(const QString& selected, const RefusedMesh& refused, const Actions& actions) {
    if (const int number = faultNumber(selected); number >= 0 && number < listedFaults(refused))
        return faultPage(number, refused, actions);
    PropertyPage page{
        refusedId(), u"error"_s, refused.name, Words::tr("Read, and not ready for a mold."), {}};
    page.layout = refused.file;
    page.sections = {
        {Words::tr("Diagnosis"),
         {reading(u"is-closed"_s, Words::tr("Closed")), reading(u"is-manifold"_s, Words::tr("Manifold")),
          reading(u"is-outward"_s, Words::tr("Faces look outward")),
          reading(u"crossing-pairs"_s, Words::tr("Pairs that cross")),
          reading(u"flat-faces"_s, Words::tr("Faces without area")),
          reading(u"pieces"_s, Words::tr("Pieces"))},
         {},
         false,
         faultSentences(refused)}};
    if (!refused.part.repairs.empty())
        page.sections.push_back(
            {Words::tr("Mended while reading"), {}, {}, false, sentencesOf(refused.part.repairs)});
    page.sections.push_back(waysOut(actions));
    return page;
}

void fillRefusedPage(PropertyPanel& panel, const RefusedMesh& refused) {
    if (const int number = faultNumber(panel.pageId()); number >= 0 && number < listedFaults(refused))
        return fillFault(panel, refused.places[static_cast<std::size_t>(number)]);
    const MeshDiagnosis& found = refused.part.diagnosis;
    const bool known = found.components > 0;
    const auto set = [&](const QString& id, const QString& value, bool good) {
        panel.setValue(id, QStringList{known ? value : u"–"_s, QString()});
        panel.setMissesGoal(id, known && !good);
    };
    const auto yesOrNo = [](bool yes) { return yes ? Words::tr("yes") : Words::tr("no"); };
    const auto count = [](std::size_t n) { return n == 0 ? Words::tr("none") : QString::number(n); };
    set(u"is-closed"_s, yesOrNo(found.closed), found.closed);
    set(u"is-manifold"_s, yesOrNo(found.manifold), found.manifold);
    set(u"is-outward"_s, yesOrNo(found.oriented), found.oriented);
    set(u"crossing-pairs"_s, count(found.selfIntersections.size()), found.selfIntersections.empty());
    set(u"flat-faces"_s, count(found.degenerateFaces.size()), found.degenerateFaces.empty());
    set(u"pieces"_s, QString::number(found.components), true);
}

FacePaint refusedPaint(const RefusedMesh& refused) {
    const scene::SceneColours& colours = theme().scene;
    const auto painted = [&](const IndexedMesh& mesh, const std::vector<int>& atFault) {
        std::vector<scene::Rgb> faces(static_cast<std::size_t>(mesh.faceCount()), colours.part);
        for (const int f : atFault)
            faces[static_cast<std::size_t>(f)] = colours.undercut;
        return faces;
    };
    FacePaint paint;
    paint.faces = painted(*refused.drawn->mesh, refused.paintedFaces);
    if (refused.drawn->standIn)
        paint.standIn = painted(*refused.drawn->standIn->mesh, refused.paintedStandIn);
    return paint;
}

scene::PanelContent refusedLegend(const RefusedMesh& refused) {
    scene::PanelContent legend;
    if (refused.places.empty())
        return legend;
    legend.title = Words::tr("Mesh problems").toStdString();
    for (int kind = 0; kind < faultKindCount; ++kind)
        if (const int count = countOf(refused, static_cast<FaultKind>(kind)))
            legend.lines.push_back({theme().scene.undercut,
                                    {{kindName(static_cast<FaultKind>(kind)).toStdString()}},
                                    std::to_string(count)});
    return legend;
}

std::vector<int> markedFaults(const RefusedMesh& refused, const QString& selected) {
    std::vector<int> marked;
    for (int i = 0; i < listedFaults(refused); ++i)
        if (i < marksAtOnce || i == faultNumber(selected))
            marked.push_back(i);
    return marked;
}

std::vector<scene::Chip> faultMarks(const RefusedMesh& refused, const QString& selected) {
    std::vector<scene::Chip> marks;
    for (const int i : markedFaults(refused, selected)) {
        const FaultPlace& place = refused.places[static_cast<std::size_t>(i)];
        const std::string words = u"%1, %2"_s.arg(nameOf(refused, i), sizeText(place)).toStdString();
        const bool bold = i == faultNumber(selected);
        marks.push_back({place.box.center(),
                         {{}, {{std::nullopt, {{words, scene::Ink::Text, bold}}, {}}}},
                         theme().scene.undercut});
    }
    return marks;
}

QString diagnosisText(const RefusedMesh& refused) {
    QStringList lines = {refused.file};
    lines += faultSentences(refused);
    lines += sentencesOf(refused.part.repairs);
    for (int i = 0; i < listedFaults(refused); ++i) {
        const FaultPlace& place = refused.places[static_cast<std::size_t>(i)];
        lines << u"%1: %2, %3"_s.arg(nameOf(refused, i), sizeText(place),
                                     threeNumbers(place.box.center(), u" "_s));
    }
    return lines.join(u'\n');
}

} // namespace moldwright
