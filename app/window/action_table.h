// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QAction>
#include <QObject>
#include <QString>

#include <functional>
#include <map>
#include <span>
#include <vector>

namespace moldwright {

/// What must be so for a command to make sense.
enum class Needs {
    Nothing,
    Idle,
    Part,
    InView,     ///< a part, or a mesh that was refused
    IdleInView, ///< the same, and idle
    Refused,    ///< a mesh is
    FaultPlace, ///< the same, and there is a place to be shown
    IdlePart,
    Plane,
    IdlePlane,
    EditablePart,  ///< idle, or a run goes on that takes up what is changed
    EditablePlane, ///< the same, and there is a plane
    SuggestedPlane,
    SuggestedPins,
    SuggestedTips,
    Pins,
    ChosenGuide,  ///< or a variant that may go, or a further part of the mold
    Variants,     ///< several, and idle
    Comparable,   ///< several
    OtherVariant, ///< one that is not the current one is chosen, and idle
    Regions,
    FillableObstruction,
    CastShape,
    ProvedCast,
    MoldBuilt,
    ChosenByHand, ///< a feature of the mold that stands where a hand put it is chosen
    AnyByHand,    ///< one stands there
    FurtherPart,  ///< of the mold is chosen, and idle
    Running,
    Bending,
    Resting,
    EarlierFrame,
    LaterFrame,
    Branch, ///< a frame in view that another run can begin from
    Measured,
    Renamable, ///< what is chosen is, and idle
    Hideable,
    LostWork, ///< found, and idle
    Undo,
    Redo
};

/// One command of the program. Menu, tool bar, shortcut, tool tip, status hint, key sheet, command search and
/// the preferences' list of keys are all made from this table.
struct ActionSpec {
    const char* id;
    const char* text; ///< English, with the mnemonic
    const char* icon; ///< name, or empty
    const char* shortcut;
    const char* hint; ///< English sentence for status bar and tool tip
    Needs needs = Needs::Nothing;
    bool checkable = false;
    bool separatorBefore = false;
    const char* menu = ""; ///< English title of its menu; the menu it stands in gives it
};

/// All commands in the order of the menus.
[[nodiscard]] std::span<const ActionSpec> actionTable();

/// The commands as Qt actions, translated, by id.
class Actions : public QObject {
    Q_OBJECT
public:
    explicit Actions(QObject* parent);

    [[nodiscard]] QAction* operator[](const QString& id) const { return m_actions.at(id); }
    [[nodiscard]] const std::vector<QAction*>& all() const { return m_ordered; }

    /// What the command does.
    void on(const QString& id, const std::function<void()>& run);

    /// The keys of a command as the table has them, and others instead, which are kept between sessions.
    [[nodiscard]] QKeySequence firstKeys(const QString& id) const;
    void setKeys(const QString& id, const QKeySequence& keys);
    void resetKeys();
    [[nodiscard]] bool anyKeysChanged() const;
    /// The command that has these keys; null for none.
    [[nodiscard]] const QAction* withKeys(const QKeySequence& keys) const;

    /// Enables each command by what it needs.
    void update(const std::function<bool(Needs)>& isSo);

private:
    std::map<QString, QAction*> m_actions;
    std::vector<QAction*> m_ordered;
};

} // namespace moldwright
