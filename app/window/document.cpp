// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/document.h"

namespace moldwright {

void Document::open(const Project& project, const QString& file) {
    m_history.clear();
    m_file = file;
    show(project);
    Q_EMIT historyChanged();
}

void Document::openUnsaved(const Project& project) {
    m_history.clear();
    m_history.markUnsaved();
    m_file.clear();
    show(project);
    Q_EMIT historyChanged();
}

void Document::edit(const QString& words, const Project& after, const QString& mergeKey) {
    if (m_project == after) {
        endPreview();
        return;
    }
    m_history.push({words, m_project, after, mergeKey});
    show(after);
    Q_EMIT historyChanged();
}

void Document::preview(const Project& project) {
    m_preview = project;
    Q_EMIT changed();
}

void Document::endPreview() {
    if (!m_preview)
        return;
    m_preview.reset();
    Q_EMIT changed();
}

void Document::undo() {
    if (!m_history.canUndo())
        return;
    show(m_history.undo());
    Q_EMIT historyChanged();
}

void Document::redo() {
    if (!m_history.canRedo())
        return;
    show(m_history.redo());
    Q_EMIT historyChanged();
}

void Document::goTo(std::size_t done) {
    if (done == m_history.done() || done > m_history.steps().size())
        return;
    Project there = m_project;
    while (m_history.done() > done)
        there = m_history.undo();
    while (m_history.done() < done)
        there = m_history.redo();
    show(there);
    Q_EMIT historyChanged();
}

void Document::markSaved(const QString& file, std::size_t done) {
    m_file = file;
    m_history.markSaved(done);
    Q_EMIT historyChanged();
}

void Document::show(const Project& project) {
    m_project = project;
    m_preview.reset();
    Q_EMIT changed();
}

} // namespace moldwright
