// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "panels/lost_card.h"

#include <QPixmap>
#include <QWidget>

#include <vector>

class QAction;
class QGridLayout;
class QLabel;
class QVBoxLayout;

namespace moldwright {

/// A bundled part on the start page.
struct SampleCard {
    QString file;
    QString name;
    QString words;
    QString picture; ///< file of its picture; may be missing
};

/// A file used lately.
struct RecentFile {
    QString file;
    QString when;
};

/// What is seen while no part is open: actions and recent files left, samples right.
class StartPage : public QWidget {
    Q_OBJECT
public:
    StartPage(QAction* open, QAction* tour, const std::vector<SampleCard>& samples,
              QWidget* parent = nullptr);

    void setRecent(const std::vector<RecentFile>& files);

    /// Shows work that was lost, the first few of it, above the recent files.
    void setLost(const std::vector<LostCard>& cards);

    /// Puts a picture on the card of this sample.
    void setPicture(const QString& file, const QPixmap& picture);

Q_SIGNALS:
    void fileChosen(const QString& file);
    void sampleChosen(const QString& file, const QString& name);
    void clearRecent();
    /// Lost work is to be opened, given up, or shown where it lies; by its number.
    void lostChosen(int which);
    void lostDiscarded(int which);
    void lostShown(int which);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    QWidget* makeLeft(QAction* open, QAction* tour);
    QWidget* makeRight(const std::vector<SampleCard>& samples);
    void arrangeCards();
    void writeClearLink();

    QGridLayout* m_grid = nullptr;
    QVBoxLayout* m_recent = nullptr;
    QVBoxLayout* m_lost = nullptr;
    std::vector<LostCard> m_lostCards;
    QWidget* m_recentHead = nullptr;
    QLabel* m_clear = nullptr;
    std::vector<QWidget*> m_cards;
};

} // namespace moldwright
