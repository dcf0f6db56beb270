// SPDX-License-Identifier: AGPL-3.0-or-later
// The start page, and work that was lost and is found there.
#include "window/main_window.h"

#include "panels/start_page.h"
#include "window/preferences.h"
#include "window/recovery.h"
#include "window/workbench.h"

#include <QDesktopServices>
#include <QFileInfo>
#include <QLocale>
#include <QUrl>

#include <algorithm>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

QString whenText(const QDateTime& when) {
    const QString time = when.toString(u"HH:mm"_s);
    return when.date() == QDate::currentDate()
               ? time
               : MainWindow::tr("%1, %2").arg(QLocale().toString(when.date(), QLocale::ShortFormat), time);
}

LostCard cardOf(const LostWork& work) {
    if (work.project)
        return {
            work.name,
            MainWindow::tr("Not saved when Moldwright ended. Kept as it was at %1.").arg(whenText(work.when)),
            work.file, work.picture, true};
    return {MainWindow::tr("Work of %1").arg(whenText(work.when)),
            MainWindow::tr("Not saved when Moldwright ended, and what was kept cannot be read."),
            work.folder->path(),
            {},
            false};
}

} // namespace

void MainWindow::connectStart() {
    connect(m_start, &StartPage::fileChosen, this, &MainWindow::openPath);
    connect(m_start, &StartPage::sampleChosen, &m_bench, &Workbench::openSample);
    connect(m_start, &StartPage::clearRecent, this, [this] {
        preferences::clearRecentFiles();
        refreshSoon();
    });
    connect(m_start, &StartPage::lostChosen, this, &MainWindow::reopenLost);
    connect(m_start, &StartPage::lostDiscarded, this,
            [this](int which) { m_recovery.discard(static_cast<std::size_t>(which)); });
    connect(m_start, &StartPage::lostShown, this, [this](int which) {
        const QString folder = m_recovery.found().at(static_cast<std::size_t>(which)).folder->path();
        QDesktopServices::openUrl(QUrl::fromLocalFile(folder));
    });
    connect(&m_recovery, &Recovery::changed, this, [this] {
        refreshSoon();
        tellOfLost();
    });
    m_actions.on(u"recover"_s, [this] { reopenLost(0); });
}

void MainWindow::showStart() {
    m_start->setRecent(preferences::recentFiles());
    std::vector<LostCard> cards;
    for (const LostWork& work : m_recovery.found())
        cards.push_back(cardOf(work));
    m_start->setLost(cards);
    m_toldOfLost = m_toldOfLost || !cards.empty();
}

void MainWindow::tellOfLost() {
    if (m_toldOfLost || m_recovery.found().empty() || !m_bench.project().part)
        return;
    m_toldOfLost = true;
    const LostWork& work = m_recovery.found().front();
    advise({Standing::Warning, tr("Another part was not saved when Moldwright ended."),
            work.project ? tr("%1 was kept as it was at %2.").arg(work.name, whenText(work.when))
                         : work.folder->path(),
            work.project ? u"recover"_s : QString()});
}

void MainWindow::reopenLost(int which) {
    if (m_bench.background().busy())
        return;
    // It may be another in the list once the document was saved.
    leaving([this, folder = m_recovery.found().at(static_cast<std::size_t>(which)).folder] {
        const auto& found = m_recovery.found();
        const auto work = std::ranges::find(found, folder, &LostWork::folder);
        if (work != found.end() && work->project)
            m_recovery.reopen(static_cast<std::size_t>(work - found.begin()));
    });
}

} // namespace moldwright
