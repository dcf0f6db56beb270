// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QWidget>

#include <vector>

namespace moldwright {

/// What one step of a run measured.
struct ProgressPoint {
    int step = 0;
    double energy = 0; ///< scale-free
    double worstDraftDegrees = 0;
    double violatingAreaFraction = 0; ///< in [0, 1]
};

/// A small number as powers of ten: "9.3·10⁻⁵".
[[nodiscard]] QString scientificText(double value);

/// Three small plots over the steps of a run: energy (logarithmic), worst draft, area below the draft; the
/// goal dashed green.
class ProgressPlots : public QWidget {
    Q_OBJECT
public:
    explicit ProgressPlots(QWidget* parent = nullptr);

    void clear();
    void add(const ProgressPoint& point);
    void setRequiredDraft(double degrees);
    /// The step in view, marked by a line; 0: none.
    void setMarked(int step);
    [[nodiscard]] const std::vector<ProgressPoint>& points() const { return m_points; }
    [[nodiscard]] QSize minimumSizeHint() const override { return {360, 104}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    struct Plot;
    /// The marked point, else the last. Precondition: there is one.
    [[nodiscard]] const ProgressPoint& told() const;
    [[nodiscard]] std::vector<Plot> plots() const;
    void paintPlot(QPainter& painter, const Plot& plot, const QRect& box) const;

    std::vector<ProgressPoint> m_points;
    double m_requiredDraft = 1;
    int m_marked = 0;
};

} // namespace moldwright
