// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QImage>
#include <QListWidget>
#include <QString>

#include <vector>

namespace moldwright {

/// A picture to choose, with two lines under it.
struct PictureChoice {
    QImage picture;  ///< on a clear ground
    QString caption; ///< bold
    QString details;
    QString help; ///< tool tip
};

/// Pictures side by side, one of them chosen: by a click or the arrow keys. As high as all of them need.
class PictureList : public QListWidget {
    Q_OBJECT
public:
    explicit PictureList(const std::vector<PictureChoice>& choices, QWidget* parent = nullptr);

    /// Marks one as chosen, −1 none; tells nobody.
    void setChosen(int index);

    /// Whether both lines of a picture are shown whole.
    [[nodiscard]] bool fits(int index) const;

    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

    /// Size of a picture, logical pixels.
    static constexpr QSize pictureSize{116, 84};

Q_SIGNALS:
    void chosen(int index);
};

} // namespace moldwright
