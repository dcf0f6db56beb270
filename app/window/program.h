// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "language/spoken_language.h"
#include "window/autosave.h"
#include "window/recovery.h"
#include "window/workbench.h"

#include <memory>
#include <optional>

namespace moldwright {

class MainWindow;

/// Style, settings and language: what must be so before the first window. Also for tests.
void prepareApplication();

/// The workbench and its window. When the language changes, the window is built anew on the same workbench.
class Program : public QObject {
    Q_OBJECT
public:
    Program();
    ~Program() override;

    [[nodiscard]] MainWindow& window() { return *m_window; }
    [[nodiscard]] Workbench& bench() { return m_bench; }
    [[nodiscard]] Autosave& autosave() { return m_autosave; }
    [[nodiscard]] Recovery& recovery() { return m_recovery; }
    void setLanguage(const QString& language);

private:
    void keepWork();
    void showWindow();

    std::optional<SpokenLanguage> m_language;
    Workbench m_bench;
    Autosave m_autosave;
    Recovery m_recovery;
    std::unique_ptr<MainWindow> m_window;
};

/// Runs the window until it closes; `arguments` may name a file to open.
int runWindow(int argc, char** argv);

} // namespace moldwright
