// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "project/project.h"

#include <QString>

#include <cstddef>
#include <vector>

namespace moldwright {

/// Undo and redo of a document that is a value: each step is a whole project before and after. Meshes are
/// shared, so a step costs what it changed. Bounded by memory: the oldest steps go first.
class History {
public:
    struct Step {
        QString words; ///< what was done
        Project before;
        Project after;
        QString mergeKey; ///< steps in a row with the same key are one, with the last words; empty: never
    };

    explicit History(std::size_t mostBytes = std::size_t(1) << 30) : m_mostBytes(mostBytes) {}

    /// Takes a step; what had been undone is gone.
    void push(Step step);
    void clear();

    [[nodiscard]] bool canUndo() const { return m_done > 0; }
    [[nodiscard]] bool canRedo() const { return m_done < m_steps.size(); }
    const Project& undo() { return m_steps[--m_done].before; }
    const Project& redo() { return m_steps[m_done++].after; }

    /// The steps, oldest first, and how many of them are done.
    [[nodiscard]] const std::vector<Step>& steps() const { return m_steps; }
    [[nodiscard]] std::size_t done() const { return m_done; }

    /// Memory that only the history holds on to, about.
    [[nodiscard]] std::size_t bytes() const;

    /// The document was saved as it is after `done` steps.
    void markSaved(std::size_t done) { m_saved = static_cast<std::ptrdiff_t>(done); }
    /// No state of the document is saved.
    void markUnsaved() { m_saved = -1; }
    [[nodiscard]] bool atSaved() const { return m_saved == static_cast<std::ptrdiff_t>(m_done); }

private:
    std::vector<Step> m_steps;
    std::size_t m_done = 0;
    std::ptrdiff_t m_saved = 0; ///< negative: the saved state can no longer be reached
    std::size_t m_mostBytes;
};

} // namespace moldwright
