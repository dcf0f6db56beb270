// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QOpenGLWidget>
#include <QTimer>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <chrono>

class vtkGenericOpenGLRenderWindow;

namespace moldwright {

/// A VTK window inside a Qt widget. VTK draws into its own buffers within the widget's OpenGL context, and
/// the finished picture is copied into the widget. Ask for a new picture with redraw(); many askings are one
/// picture. A picture that takes long is drawn in slices between other events, the one before it staying in
/// view until it is complete.
class RenderView : public QOpenGLWidget {
    Q_OBJECT
public:
    explicit RenderView(QWidget* parent = nullptr);
    ~RenderView() override;

    [[nodiscard]] vtkGenericOpenGLRenderWindow* window() const { return m_window; }

    void redraw();

    /// The newest picture, drawn now if it has to be.
    [[nodiscard]] QImage picture();

    /// How long the last complete picture took to draw.
    [[nodiscard]] std::chrono::milliseconds lastPicture() const { return m_lastPicture; }
    /// Whether a picture asked for is not complete yet.
    [[nodiscard]] bool drawing() const { return m_stale; }

protected:
    /// Called before each picture with its size in device pixels. `quick`: a picture must be there at once,
    /// coarse as it may be; another one follows.
    virtual void prepare(int width, int height, bool quick) = 0;

    /// Whether the next picture takes so long that it is to be drawn in slices.
    [[nodiscard]] virtual bool drawsInSlices() const = 0;
    [[nodiscard]] virtual int sliceCount() const = 0;
    /// Called before each slice.
    virtual void prepareSlice(int slice) = 0;

    /// A picture is complete; lastPicture() tells of it.
    virtual void pictureDone() {}

    /// What is seen of a view that was just shown and waits for its turn.
    [[nodiscard]] virtual QColor ground() const = 0;

    void showEvent(QShowEvent* event) override;
    void initializeGL() override;
    void paintGL() override;

private:
    void releaseContext();
    void makeCurrentForVtk();
    void fitWindow();
    void drawAtOnce();
    void drawNextSlice();
    void renderWindow();
    void copyToWidget();
    void showGround();

    vtkNew<vtkGenericOpenGLRenderWindow> m_window;
    QTimer m_sliceTimer;
    int m_slice = 0;            ///< the next one to be drawn
    bool m_stale = true;        ///< another picture was asked for
    bool m_now = false;         ///< it cannot wait for its turn
    bool m_justShown = true;    ///< nobody has seen a picture of it yet
    bool m_havePicture = false; ///< one of the right size, complete or coarse
    std::chrono::steady_clock::duration m_spent{};
    std::chrono::milliseconds m_lastPicture{0};
};

} // namespace moldwright
