// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "project/project.h"
#include "window/history.h"

#include <QObject>
#include <QString>

#include <optional>

namespace moldwright {

/// The open project, its history, and the file it belongs to. All changes pass through here.
class Document : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    /// What is shown: the project, or its preview while something is dragged.
    [[nodiscard]] const Project& project() const { return m_preview ? *m_preview : m_project; }
    [[nodiscard]] const Project& committed() const { return m_project; }
    [[nodiscard]] const History& history() const { return m_history; }

    /// A new document; the old history is gone.
    void open(const Project& project, const QString& file);
    /// The same with one that is in no file: it counts as changed.
    void openUnsaved(const Project& project);

    /// One undo step. An edit that changes nothing is none.
    void edit(const QString& words, const Project& after, const QString& mergeKey = {});

    /// Shows `project` without a step, until edit() or endPreview().
    void preview(const Project& project);
    void endPreview();

    void undo();
    void redo();
    /// Goes to where `done` steps are done.
    void goTo(std::size_t done);

    [[nodiscard]] bool isChanged() const { return !m_history.atSaved(); }
    [[nodiscard]] const QString& file() const { return m_file; }
    /// What was saved is the project after `done` steps.
    void markSaved(const QString& file, std::size_t done);

Q_SIGNALS:
    /// The project shown is another; derived things follow.
    void changed();
    /// History, file or saved mark are others.
    void historyChanged();

private:
    void show(const Project& project);

    Project m_project;
    std::optional<Project> m_preview;
    History m_history;
    QString m_file;
};

} // namespace moldwright
