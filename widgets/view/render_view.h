// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QOpenGLWidget>

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <chrono>

class vtkGenericOpenGLRenderWindow;

namespace moldwright {

/// A VTK window inside a Qt widget. VTK draws into its own buffers within the widget's OpenGL context, and
/// the picture is copied into the widget. Ask for a new picture with update(); many askings are one picture.
class RenderView : public QOpenGLWidget {
    Q_OBJECT
public:
    explicit RenderView(QWidget* parent = nullptr);
    ~RenderView() override;

    [[nodiscard]] vtkGenericOpenGLRenderWindow* window() const { return m_window; }

    /// How long the last picture took to draw.
    [[nodiscard]] std::chrono::milliseconds lastPicture() const { return m_lastPicture; }

protected:
    /// Called before each picture, with its size in device pixels.
    virtual void aboutToRender(int width, int height) = 0;

    void initializeGL() override;
    void paintGL() override;

private:
    void releaseContext();
    void makeCurrentForVtk();

    vtkNew<vtkGenericOpenGLRenderWindow> m_window;
    std::chrono::milliseconds m_lastPicture{0};
};

} // namespace moldwright
