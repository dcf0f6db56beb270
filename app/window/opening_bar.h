// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QFrame>

class QLabel;
class QSlider;

namespace moldwright {

/// The strip over the views while a mold is shown: how far it is open, from closed over apart to lying open
/// like a book.
class OpeningBar : public QFrame {
    Q_OBJECT
public:
    explicit OpeningBar(QWidget* parent = nullptr);

    [[nodiscard]] double opening() const; ///< 0 to 1, as scene::openingAt() has it
    /// Moves the slider there, as fast as a hand would.
    void ease(double opening);

Q_SIGNALS:
    void openingChanged(double opening);

private:
    void tell();

    QSlider* m_slider;
    QLabel* m_words;
};

} // namespace moldwright
