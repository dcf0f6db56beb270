// SPDX-License-Identifier: AGPL-3.0-or-later
// GLEW 2.2 asks GLX for its display and answers GLEW_ERROR_NO_GLX_DISPLAY where the context is EGL's. It has
// loaded every function by then, but VTK gives up half-way and draws wrong pictures. A program that draws
// without X (or on Wayland) links this file and exports its symbols: VTK then finds this glewInit first.
#include <dlfcn.h>

extern "C" unsigned glewInit() {
    constexpr unsigned ok = 0;
    constexpr unsigned noGlxDisplay = 4;
    using Init = unsigned (*)();
    const auto real = reinterpret_cast<Init>(dlsym(RTLD_NEXT, "glewInit"));
    if (!real)
        return noGlxDisplay;
    const unsigned result = real();
    return result == noGlxDisplay ? ok : result;
}
