// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "scene/camera.h"
#include "scene/offscreen/egl_context.h"
#include "scene/scene.h"

#include <cstdint>
#include <string>
#include <vector>

namespace moldwright::scene {

/// A picture in memory: rows from top to bottom, red, green, blue per pixel.
struct Picture {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;

    [[nodiscard]] Rgb at(int x, int y) const {
        const std::uint8_t* p = &rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                          static_cast<std::size_t>(x))];
        return {p[0], p[1], p[2]};
    }
};

/// Draws a scene without a display, looking from `from` with all of it in sight. Drawn at twice the size and
/// halved: edges come out smooth on any driver. The scene must not be in another window.
[[nodiscard]] Picture renderPicture(Scene& scene, const EglContext& context, const Eigen::Vector3d& from,
                                    int width, int height);

/// The part of a picture that is not all `background`, within a margin of a hundredth of its width; the whole
/// when nothing is.
[[nodiscard]] Picture cropped(const Picture& picture, Rgb background);

/// The bytes of a PNG file.
[[nodiscard]] std::string pngBytes(const Picture& picture);

} // namespace moldwright::scene
