// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/offscreen/egl_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace moldwright::scene {

namespace {

std::unexpected<Error> unavailable(const char* what) {
    return failure(ErrorCode::Internal,
                   MW_TEXT("Pictures", "Pictures cannot be drawn on this machine: OpenGL {0}."), {what});
}

EGLContext contextOn(EGLDisplay display) {
    // The default asks for windows, which nothing without a display has.
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                             EGL_NONE};
    const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                              3,
                              EGL_CONTEXT_MINOR_VERSION,
                              2,
                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                              EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, wanted, &config, 1, &count) || count == 0 || !eglBindAPI(EGL_OPENGL_API))
        return EGL_NO_CONTEXT;
    return eglCreateContext(display, config, EGL_NO_CONTEXT, version);
}

} // namespace

Result<std::unique_ptr<EglContext>> EglContext::create() {
    EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr))
        return unavailable("has no display-free mode");
    EGLContext context = contextOn(display);
    if (context == EGL_NO_CONTEXT) {
        eglTerminate(display);
        return unavailable("3.2 is missing");
    }
    std::unique_ptr<EglContext> created(new EglContext(display, context));
    created->makeCurrent();
    if (!created->isCurrent())
        return unavailable("cannot draw without a window");
    return created;
}

EglContext::~EglContext() {
    eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(m_display, m_context);
    eglTerminate(m_display);
}

void EglContext::makeCurrent() const {
    if (!isCurrent())
        eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_context);
}

bool EglContext::isCurrent() const {
    return eglGetCurrentContext() == m_context;
}

} // namespace moldwright::scene
