// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "theme/icons.h"

#include <QToolBar>
#include <QToolButton>

#include <vector>

class QActionGroup;

namespace moldwright {

class StepButton;

/// Answers the one question of the window: an icon, a sentence, a reason. A click shows the worst place.
class VerdictButton : public QToolButton {
    Q_OBJECT
public:
    explicit VerdictButton(QWidget* parent = nullptr);
    void setVerdict(Standing standing, const QString& sentence, const QString& reason);
    [[nodiscard]] const QString& sentence() const { return m_sentence; }
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Standing m_standing = Standing::Info;
    QString m_sentence;
    QString m_reason;
};

/// The steps of the job, any at any time, and the verdict at the right end.
class WorkflowBar : public QToolBar {
    Q_OBJECT
public:
    struct Step {
        QString iconName;
        QString name;
    };

    WorkflowBar(const std::vector<Step>& steps, QWidget* parent = nullptr);

    void setStanding(int step, Standing standing, const QString& words);
    void setCurrentStep(int step);
    void setStepsEnabled(bool enabled);
    [[nodiscard]] VerdictButton* verdict() const { return m_verdict; }
    [[nodiscard]] StepButton* step(int index) const { return m_steps[index]; }

Q_SIGNALS:
    void stepChosen(int step);
    void verdictClicked();

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    /// Where the bar is too narrow for all their states, the steps show their names alone.
    void fitSteps();

    std::vector<StepButton*> m_steps;
    VerdictButton* m_verdict;
};

} // namespace moldwright
