// SPDX-License-Identifier: AGPL-3.0-or-later
#include "theme/icons.h"

#include "theme/theme.h"

#include <QFile>
#include <QHash>
#include <QIconEngine>
#include <QPainter>
#include <QSvgRenderer>

namespace moldwright {

namespace {

/// The drawing's text. `LINE` stands for the line's colour, `TONE` for the shape's, `SHARE` for its opacity.
QByteArray drawing(const QString& name) {
    static QHash<QString, QByteArray> known;
    if (const auto found = known.constFind(name); found != known.constEnd())
        return *found;
    QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
    const QByteArray text = file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    return *known.insert(name, text);
}

constexpr double lineOnlySize = 16; ///< logical pixels up to which there is no tone

class ThemeIconEngine : public QIconEngine {
public:
    ThemeIconEngine(QString name, std::optional<QColor> tint) : m_name(std::move(name)), m_tint(tint) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        draw(painter, rect, mode, rect.width() > lineOnlySize);
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        return scaledPixmap(size, mode, state, 1);
    }

    QPixmap scaledPixmap(const QSize& size, QIcon::Mode mode, QIcon::State, qreal ratio) override {
        QPixmap picture(size);
        picture.fill(Qt::transparent);
        QPainter painter(&picture);
        painter.setRenderHint(QPainter::Antialiasing);
        draw(&painter, QRect(QPoint(0, 0), size), mode, size.width() > lineOnlySize * ratio);
        return picture;
    }

    [[nodiscard]] QIconEngine* clone() const override { return new ThemeIconEngine(*this); }

private:
    void draw(QPainter* painter, const QRect& rect, QIcon::Mode mode, bool toned) const {
        const QPalette& palette = theme().palette;
        QColor line = m_tint.value_or(palette.color(QPalette::WindowText));
        QColor tone = m_tint.value_or(palette.color(QPalette::Highlight));
        toned = toned || m_tint;
        if (mode == QIcon::Disabled) {
            line = palette.color(QPalette::Disabled, QPalette::Text);
            toned = false;
        } else if (mode == QIcon::Selected) {
            line = tone = Qt::white;
        }
        const double share = !toned ? 0 : m_tint ? 0.16 : theme().dark ? 0.55 : 0.26;
        QByteArray svg = drawing(m_name);
        svg.replace("LINE", line.name().toLatin1());
        svg.replace("TONE", tone.name().toLatin1());
        svg.replace("SHARE", QByteArray::number(share));
        QSvgRenderer(svg).render(painter, rect);
    }

    QString m_name;
    std::optional<QColor> m_tint;
};

} // namespace

QIcon themeIcon(const QString& name) {
    return QIcon(new ThemeIconEngine(name, std::nullopt));
}

QIcon tintedIcon(const QString& name, const QColor& colour) {
    return QIcon(new ThemeIconEngine(name, colour));
}

QColor standingColour(Standing standing) {
    switch (standing) {
    case Standing::Done:
        return theme().done;
    case Standing::Stale:
    case Standing::Warning:
        return theme().warning;
    case Standing::Failing:
        return theme().error;
    case Standing::Running:
        return theme().palette.color(QPalette::Link);
    case Standing::Info:
    case Standing::Todo:
        break;
    }
    return theme().palette.color(QPalette::PlaceholderText);
}

QIcon standingIcon(Standing standing) {
    const QColor colour = standingColour(standing);
    switch (standing) {
    case Standing::Todo:
        return tintedIcon(QStringLiteral("todo"), colour);
    case Standing::Info:
        return themeIcon(QStringLiteral("info"));
    case Standing::Done:
        return tintedIcon(QStringLiteral("ok"), colour);
    case Standing::Stale:
        return tintedIcon(QStringLiteral("stale"), colour);
    case Standing::Warning:
        return tintedIcon(QStringLiteral("warn"), colour);
    case Standing::Failing:
        return tintedIcon(QStringLiteral("error"), colour);
    case Standing::Running:
        return tintedIcon(QStringLiteral("running"), colour);
    }
    return {};
}

} // namespace moldwright
