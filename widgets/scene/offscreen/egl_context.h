// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"

#include <memory>

namespace moldwright::scene {

/// An OpenGL 3.2 context without a display, a window or a surface: pictures are drawn into framebuffers.
class EglContext {
public:
    /// Errors: Internal when this machine's OpenGL offers none.
    [[nodiscard]] static Result<std::unique_ptr<EglContext>> create();
    ~EglContext();
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

    void makeCurrent() const;
    [[nodiscard]] bool isCurrent() const;

private:
    EglContext(void* display, void* context) : m_display(display), m_context(context) {}
    void* m_display;
    void* m_context;
};

} // namespace moldwright::scene
