// SPDX-License-Identifier: AGPL-3.0-or-later
#include "view/render_view.h"

#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QSurfaceFormat>

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>

#include <cmath>

namespace moldwright {

namespace {

QSurfaceFormat formatForVtk() {
    QSurfaceFormat format;
    format.setRenderableType(QSurfaceFormat::OpenGL);
    format.setVersion(3, 2);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    format.setSamples(0);
    return format;
}

/// Forwards a VTK event to a function.
template <class F>
void observe(vtkObject* object, unsigned long event, F function) {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(new F(std::move(function)));
    command->SetClientDataDeleteCallback([](void* data) { delete static_cast<F*>(data); });
    command->SetCallback([](vtkObject*, unsigned long, void* data, void*) { (*static_cast<F*>(data))(); });
    object->AddObserver(event, command);
}

} // namespace

RenderView::RenderView(QWidget* parent) : QOpenGLWidget(parent) {
    setFormat(formatForVtk());
    setUpdateBehavior(QOpenGLWidget::NoPartialUpdate);
    m_window->SetOwnContext(0);
    m_window->SetReadyForRendering(false);
    m_window->SetFrameBlitModeToNoBlit();
    m_window->SetMultiSamples(0);
    observe(m_window, vtkCommand::WindowMakeCurrentEvent, [this] { makeCurrentForVtk(); });
    observe(m_window, vtkCommand::WindowIsCurrentEvent,
            [this] { m_window->SetIsCurrent(context() && QOpenGLContext::currentContext() == context()); });
}

RenderView::~RenderView() {
    releaseContext();
    // The context outlives this part of the object: it must not call back.
    if (context())
        disconnect(context(), nullptr, this, nullptr);
    m_window->RemoveAllObservers();
}

void RenderView::makeCurrentForVtk() {
    // makeCurrent() also binds the widget's own framebuffer; in the middle of VTK's drawing that would send
    // the picture to the wrong place.
    if (context() && QOpenGLContext::currentContext() != context())
        makeCurrent();
}

void RenderView::initializeGL() {
    // Floating and re-parenting a dock gives the widget a new context: VTK must let go of the old one first.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &RenderView::releaseContext,
            Qt::ConnectionType(Qt::DirectConnection | Qt::UniqueConnection));
    m_window->SetForceMaximumHardwareLineWidth(1);
    m_window->SetReadyForRendering(true);
    m_window->InitializeFromCurrentContext();
    m_window->SetUseOffScreenBuffers(false);
}

void RenderView::releaseContext() {
    if (!context() || !m_window->GetReadyForRendering())
        return;
    makeCurrent();
    m_window->Finalize();
    m_window->SetReadyForRendering(false);
    doneCurrent();
}

void RenderView::paintGL() {
    if (!m_window->GetReadyForRendering())
        return;
    const auto start = std::chrono::steady_clock::now();
    const int pixelsWide = static_cast<int>(std::lround(width() * devicePixelRatioF()));
    const int pixelsHigh = static_cast<int>(std::lround(height() * devicePixelRatioF()));
    m_window->SetSize(pixelsWide, pixelsHigh);
    aboutToRender(pixelsWide, pixelsHigh);

    vtkOpenGLState* state = m_window->GetState();
    state->Reset();
    state->Push();
    state->vtkglDepthFunc(GL_LEQUAL);
    m_window->Render();
    QOpenGLFunctions* gl = context()->functions();
    gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
    m_window->BlitDisplayFramebuffer(0, 0, 0, pixelsWide, pixelsHigh, 0, 0, pixelsWide, pixelsHigh,
                                     GL_COLOR_BUFFER_BIT, GL_NEAREST);
    // See-through pixels would let the desktop shine through the window.
    gl->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
    gl->glDisable(GL_SCISSOR_TEST);
    gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    gl->glClearColor(0, 0, 0, 1);
    gl->glClear(GL_COLOR_BUFFER_BIT);
    gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    state->Pop();
    m_lastPicture =
        std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now() - start);
}

} // namespace moldwright
