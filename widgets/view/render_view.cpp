// SPDX-License-Identifier: AGPL-3.0-or-later
#include "view/render_view.h"

#include "view/drawing_turns.h"

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
    // At no time but between other events, so that none waits for more than a slice.
    m_sliceTimer.setSingleShot(true);
    m_sliceTimer.setInterval(0);
    connect(&m_sliceTimer, &QTimer::timeout, this, &RenderView::drawNextSlice);
}

RenderView::~RenderView() {
    DrawingTurns::all().forget(*this);
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
    m_stale = true;
    m_havePicture = false;
}

void RenderView::releaseContext() {
    if (!context() || !m_window->GetReadyForRendering())
        return;
    makeCurrent();
    m_window->Finalize();
    m_window->SetReadyForRendering(false);
    doneCurrent();
}

void RenderView::redraw() {
    m_stale = true;
    m_slice = 0;
    m_sliceTimer.stop();
    if (drawsInSlices() && m_havePicture && isVisible())
        m_sliceTimer.start();
    else
        update();
}

QImage RenderView::picture() {
    m_now = true;
    QImage picture = grabFramebuffer();
    m_now = false;
    return picture;
}

void RenderView::fitWindow() {
    const int wide = static_cast<int>(std::lround(width() * devicePixelRatioF()));
    const int high = static_cast<int>(std::lround(height() * devicePixelRatioF()));
    const int* size = m_window->GetSize();
    if (size[0] == wide && size[1] == high)
        return;
    m_window->SetSize(wide, high);
    m_stale = true;
    m_havePicture = false;
}

void RenderView::paintGL() {
    if (!m_window->GetReadyForRendering())
        return;
    fitWindow();
    vtkOpenGLState* state = m_window->GetState();
    state->Reset();
    state->Push();
    // A view with a picture, or without one so far, can wait while another one draws; one that is drawn at
    // another size would flicker.
    const bool atOnce = m_stale && !(drawsInSlices() && m_havePicture);
    if (atOnce && (m_now || DrawingTurns::all().take(*this) || !(m_havePicture || m_justShown)))
        drawAtOnce();
    m_havePicture ? copyToWidget() : showGround();
    state->Pop();
}

void RenderView::showEvent(QShowEvent* event) {
    QOpenGLWidget::showEvent(event);
    m_justShown = true;
}

void RenderView::showGround() {
    QOpenGLFunctions* gl = context()->functions();
    gl->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
    gl->glDisable(GL_SCISSOR_TEST);
    const QColor colour = ground();
    gl->glClearColor(static_cast<float>(colour.redF()), static_cast<float>(colour.greenF()),
                     static_cast<float>(colour.blueF()), 1);
    gl->glClear(GL_COLOR_BUFFER_BIT);
}

void RenderView::drawAtOnce() {
    const bool quick = drawsInSlices();
    m_spent = {};
    prepare(m_window->GetSize()[0], m_window->GetSize()[1], quick);
    renderWindow();
    m_havePicture = true;
    m_justShown = false;
    if (quick) {
        m_slice = 0;
        m_sliceTimer.start();
        return;
    }
    m_stale = false;
    m_lastPicture = std::chrono::duration_cast<std::chrono::milliseconds>(m_spent);
    pictureDone();
}

void RenderView::drawNextSlice() {
    if (!m_window->GetReadyForRendering() || !m_stale)
        return;
    makeCurrent();
    vtkOpenGLState* state = m_window->GetState();
    state->Reset();
    state->Push();
    if (m_slice == 0) {
        m_spent = {};
        prepare(m_window->GetSize()[0], m_window->GetSize()[1], false);
    }
    prepareSlice(m_slice++);
    renderWindow();
    state->Pop();
    doneCurrent();
    if (m_slice < sliceCount()) {
        m_sliceTimer.start();
        return;
    }
    m_stale = false;
    m_lastPicture = std::chrono::duration_cast<std::chrono::milliseconds>(m_spent);
    pictureDone();
    update();
}

void RenderView::renderWindow() {
    const auto start = std::chrono::steady_clock::now();
    m_window->GetState()->vtkglDepthFunc(GL_LEQUAL);
    m_window->Render();
    context()->functions()->glFinish(); // what is drawn later would be counted elsewhere, and waited for
    m_spent += std::chrono::steady_clock::now() - start;
}

void RenderView::copyToWidget() {
    const int* size = m_window->GetSize();
    QOpenGLFunctions* gl = context()->functions();
    gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
    m_window->BlitDisplayFramebuffer(0, 0, 0, size[0], size[1], 0, 0, size[0], size[1], GL_COLOR_BUFFER_BIT,
                                     GL_NEAREST);
    // See-through pixels would let the desktop shine through the window.
    gl->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
    gl->glDisable(GL_SCISSOR_TEST);
    gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    gl->glClearColor(0, 0, 0, 1);
    gl->glClear(GL_COLOR_BUFFER_BIT);
    gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

} // namespace moldwright
