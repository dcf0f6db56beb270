// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/obstruction_words.h"

#include "theme/theme.h"
#include "window/row_id.h"

#include <QCoreApplication>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(ObstructionWords)
};

} // namespace

QString kindName(Obstruction::Kind kind) {
    switch (kind) {
    case Obstruction::Kind::Pocket:
        return Words::tr("Pocket of air");
    case Obstruction::Kind::ClosedPiece:
        return Words::tr("Closed piece");
    case Obstruction::Kind::Handle:
        return Words::tr("Handle or arch");
    case Obstruction::Kind::Link:
        return Words::tr("Linked pieces");
    case Obstruction::Kind::SteepFaces:
        return Words::tr("Steep faces");
    }
    return {};
}

QString sizeText(const Obstruction& obstruction) {
    return u"%1 mm"_s.arg(obstruction.size, 0, 'f', 1);
}

QString remedyFor(const Obstruction& obstruction) {
    const bool fillable =
        obstruction.kind == Obstruction::Kind::Pocket || obstruction.kind == Obstruction::Kind::Handle;
    return fillable ? u"fill-and-run"_s : u"best-plane"_s;
}

std::vector<scene::Chip> marksOf(const std::vector<Obstruction>& obstructions, int chosen) {
    std::vector<scene::Chip> marks;
    for (const Obstruction& obstruction : obstructions) {
        const bool bold = static_cast<int>(marks.size()) == chosen;
        const QString words = u"%1, %2"_s.arg(kindName(obstruction.kind), sizeText(obstruction));
        marks.push_back({obstruction.place,
                         {{}, {{std::nullopt, {{words.toStdString(), scene::Ink::Text, bold}}, {}}}},
                         theme().scene.undercut});
    }
    return marks;
}

QString obstructionId(int number) {
    return u"obstruction-%1"_s.arg(number);
}

int obstructionNumber(const QString& id) {
    return numberAfter(u"obstruction-"_s, id);
}

} // namespace moldwright
