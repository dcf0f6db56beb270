// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "window/program.h"

#include <QString>

#include <functional>

class QWidget;

namespace moldwright::test {

/// Drives the real window by the events a user makes, and waits for what comes of them.
class WindowDriver {
public:
    WindowDriver();
    ~WindowDriver();

    [[nodiscard]] MainWindow& window() { return m_program.window(); }
    [[nodiscard]] Workbench& bench() { return m_program.bench(); }
    [[nodiscard]] Program& program() { return m_program; }

    /// Handles events until `condition` holds; false after `milliseconds`.
    bool waitFor(const std::function<bool()>& condition, int milliseconds = 30000);

    /// Until no job runs and the analysis is that of what is shown.
    bool waitIdle(int milliseconds = 120000);

    /// Presses keys with the focus where it is, as in "Ctrl+Z".
    void press(const char* keys);

    /// Clicks the widget with this object name.
    void click(const char* objectName);

    /// Types into the number field with this object name, and ends with Return.
    void type(const char* field, const char* text);

    /// Clicks the project tree's row with this id.
    void selectRow(const char* id);

    /// Opens a bundled sample through its card on the start page.
    bool openSample(const char* baseName);

    /// Opens a mesh file by the menu's key and the file dialog, and scales it to this longest side, mm.
    bool openMesh(const QString& file, double longestSide);

    /// Once the next modal file dialog is open, types the path into it and accepts.
    void answerFileDialog(const QString& path);

    /// Once the next modal question is open, clicks its button with this object name.
    void answerQuestion(const char* button);

    /// Saves a picture of the window, or of a dialog, when MOLDWRIGHT_SCREENSHOTS names a folder.
    void shot(const char* name, const QWidget* of = nullptr);

private:
    /// Until the window manager has given this program the keys.
    bool waitActive();

    /// What stands in the way, for whoever reads of a wait that was in vain.
    void tellWhatIsSeen(int milliseconds);

    /// Tries every 50 ms until `answer` found its dialog.
    void whenAsked(const std::function<bool()>& answer);

    Program m_program;
    QString m_problems;
};

} // namespace moldwright::test
