// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QImage>
#include <QString>

namespace moldwright {

/// Work that was not saved, as the start page shows it.
struct LostCard {
    QString name;
    QString words; ///< what became of it, and when
    QString path;  ///< of its file, or where it lies
    QImage picture;
    bool readable = true; ///< else it can only be looked at where it lies

    bool operator==(const LostCard&) const = default;
};

/// An amber card that offers it.
class LostCardFrame : public QFrame {
    Q_OBJECT
public:
    explicit LostCardFrame(const LostCard& card, QWidget* parent = nullptr);

Q_SIGNALS:
    void reopenChosen();
    void discardChosen();
    void showChosen();

protected:
    void paintEvent(QPaintEvent* event) override;
};

} // namespace moldwright
