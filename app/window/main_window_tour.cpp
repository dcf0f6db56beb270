// SPDX-License-Identifier: AGPL-3.0-or-later
// The tour: five steps from a part to its mold.
#include "window/main_window.h"

#include "window/tour.h"
#include "window/workbench.h"

namespace moldwright {

using namespace Qt::StringLiterals;

void MainWindow::startTour() {
    if (m_tour)
        return;
    const auto key = [this](const QString& id) {
        return u"<b>%1</b>"_s.arg(m_actions[id]->shortcut().toString(QKeySequence::NativeText));
    };
    const std::vector<TourStep> steps = {
        {tr("Open a part"),
         tr("Click the sitting rabbit. A part of your own opens with %1.").arg(key(u"open"_s)),
         u"sample-rabbit"_s, [this] { return m_bench.project().part != nullptr; }},
        {tr("Choose where the mold parts"),
         tr("%1 searches the best planes. Try the pictures at the right: red is what would lock in the mold, "
            "and less of it is to be bent.")
             .arg(key(u"best-plane"_s)),
         u"dock-properties"_s, [this] { return m_bench.project().planeChosenByHand; }},
        {tr("Bend it until it comes out"),
         tr("%1 runs. The part bends before your eyes until nothing is red, and the result is proved. What "
            "you "
            "want to hold on the plane, pin it first, under Guides.")
             .arg(key(u"run"_s)),
         u"dock-progress"_s, [this] { return m_bench.castIsProved(); }},
        {tr("Look at it"),
         tr("Turn it with %1 held. %2 paints how far cast and part are apart, %3 how steep each face is. If "
            "an "
            "ear went wrong, take another plane and run again.")
             .arg(u"<b>%1</b>"_s.arg(tr("Shift and the middle button")), key(u"show-deviation"_s),
                  key(u"show-draft"_s)),
         u"view-1"_s,
         [this] {
             return m_actions[u"show-deviation"_s]->isChecked() || m_actions[u"show-draft"_s]->isChecked();
         }},
        {tr("Make the mold"),
         tr("%1 builds both halves and proves that they open. %2 moves them apart; %3 writes them to files.")
             .arg(key(u"build-mold"_s), key(u"open-mold"_s), key(u"export-mold"_s)),
         u"dock-project"_s, [this] { return m_bench.moldIsCurrent(); }},
    };
    m_tour = new Tour(steps, this);
    connect(m_tour, &Tour::ended, this, [this] {
        m_tour->deleteLater();
        m_tour = nullptr;
    });
}

} // namespace moldwright
