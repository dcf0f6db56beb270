// SPDX-License-Identifier: AGPL-3.0-or-later
#include "panels/key_sheet.h"

#include "panels/plain_text.h"

#include <QAction>
#include <QCoreApplication>
#include <QGridLayout>
#include <QLabel>
#include <QScrollArea>
#include <QVBoxLayout>

#include <map>

namespace moldwright {

namespace {

struct Line {
    QString keys;
    QString words;
};

QString motionWords(scene::Motion motion) {
    switch (motion) {
    case scene::Motion::Orbit:
        return KeySheet::tr("Orbit about the point under the pointer");
    case scene::Motion::Pan:
        return KeySheet::tr("Pan");
    case scene::Motion::Zoom:
        return KeySheet::tr("Zoom to the pointer");
    case scene::Motion::None:
        break;
    }
    return {};
}

std::vector<std::pair<QString, std::vector<Line>>> linesFor(const std::vector<QAction*>& commands,
                                                            const scene::NavigationScheme& navigation) {
    std::vector<std::pair<QString, std::vector<Line>>> groups;
    std::vector<Line> mouse;
    for (const auto& drag : navigation.drags)
        mouse.push_back({wordsFor(drag.held), motionWords(drag.motion)});
    mouse.push_back({KeySheet::tr("Wheel"), motionWords(navigation.wheelFor({}))});
    groups.emplace_back(KeySheet::tr("Mouse: %1").arg(QString::fromStdString(navigation.name)), mouse);
    for (const QAction* command : commands) {
        if (command->shortcut().isEmpty())
            continue;
        const QString menu = plainText(command->property("menu").toString());
        if (groups.back().first != menu)
            groups.emplace_back(menu, std::vector<Line>());
        groups.back().second.push_back({command->shortcut().toString(QKeySequence::NativeText),
                                        plainText(command->text()).remove(u'…')});
    }
    return groups;
}

QLabel* makeLabel(const QString& text, QWidget* parent, bool bold) {
    auto* label = new QLabel(text, parent);
    QFont font = label->font();
    font.setBold(bold);
    label->setFont(font);
    return label;
}

} // namespace

QString wordsFor(const scene::Held& held) {
    QStringList words;
    if (held.ctrl)
        words << KeySheet::tr("Ctrl");
    if (held.shift)
        words << KeySheet::tr("Shift");
    if (held.alt)
        words << KeySheet::tr("Alt");
    if (held.left)
        words << KeySheet::tr("left button");
    if (held.middle)
        words << KeySheet::tr("middle button");
    if (held.right)
        words << KeySheet::tr("right button");
    return words.join(QStringLiteral(" + "));
}

KeySheet::KeySheet(const std::vector<QAction*>& commands, const scene::NavigationScheme& navigation,
                   QWidget* parent)
    : QDialog(parent) {
    setWindowTitle(tr("Keys and mouse"));
    auto* scroll = new QScrollArea(this);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    auto* sheet = new QWidget(scroll);
    auto* columns = new QHBoxLayout(sheet);
    columns->setContentsMargins(20, 16, 20, 16);
    columns->setSpacing(40);
    const auto groups = linesFor(commands, navigation);
    std::size_t total = 0;
    for (const auto& group : groups)
        total += group.second.size() + 2;
    constexpr std::size_t columnCount = 3;
    QGridLayout* grid = nullptr;
    int row = 0;
    std::size_t placed = 0;
    for (const auto& [title, lines] : groups) {
        if (!grid || placed >= total / columnCount) {
            auto* column = new QVBoxLayout;
            grid = new QGridLayout;
            grid->setHorizontalSpacing(16);
            grid->setVerticalSpacing(4);
            column->addLayout(grid);
            column->addStretch(1);
            columns->addLayout(column);
            row = 0;
            placed = 0;
        }
        if (row > 0)
            grid->setRowMinimumHeight(row++, 8);
        grid->addWidget(makeLabel(title, sheet, true), row++, 0, 1, 2);
        for (const Line& line : lines) {
            auto* keys = makeLabel(line.keys, sheet, false);
            keys->setForegroundRole(QPalette::PlaceholderText);
            grid->addWidget(makeLabel(line.words, sheet, false), row, 0);
            grid->addWidget(keys, row++, 1);
        }
        placed += lines.size() + 2;
    }
    scroll->setWidget(sheet);
    auto* box = new QVBoxLayout(this);
    box->setContentsMargins(0, 0, 0, 0);
    box->addWidget(scroll);
    resize(sheet->sizeHint().boundedTo({1100, 640}) + QSize(16, 8));
}

} // namespace moldwright
