// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "scene/camera.h"
#include "window/animated_png.h"

#include <QObject>
#include <QPointer>
#include <QThread>
#include <QTimer>

namespace moldwright {

class PartView;

/// Turns a view once about the upright axis and takes a picture at each step, between other events; a thread
/// of its own packs them. The camera ends where it began.
class Turntable : public QObject {
    Q_OBJECT
public:
    static constexpr int pictures = 72;
    static constexpr int millisecondsEach = 60;

    explicit Turntable(PartView& view, QObject* parent = nullptr);
    ~Turntable() override;

    void start();
    /// Ends; what was not finished is not made.
    void end();

Q_SIGNALS:
    void progressed(int picturesTaken);
    /// All round: an animated PNG.
    void finished(const moldwright::AnimatedPng& animation);
    /// After finished(), and when it was given up.
    void ended();

private:
    void lookOn();
    void takePicture();
    void packed();

    QPointer<PartView> m_view;
    scene::Camera m_from;
    QTimer m_timer;
    int m_taken = 0;
    int m_packed = 0;
    bool m_over = false;
    AnimatedPng m_animation{millisecondsEach}; ///< the thread's, until all pictures are packed
    QThread m_thread;
    QObject m_place; ///< lives on the thread
};

} // namespace moldwright
