// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/small_picture.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace moldwright::scene {

namespace {

constexpr int finer = 3; ///< drawn so many times finer, then averaged
constexpr float farAway = std::numeric_limits<float>::infinity();

/// A canvas with depths; the nearest of what is drawn opaquely stays.
class Canvas {
public:
    Canvas(int width, int height)
        : m_width(width), m_height(height),
          m_colour(static_cast<std::size_t>(width) * height, Eigen::Vector4f::Zero()),
          m_depth(m_colour.size(), farAway) {}

    /// Calls `at(pixel, depth)` for each pixel of a triangle; corners are pixels with a depth as z.
    template <class At>
    void eachPixel(const std::array<Eigen::Vector3d, 3>& p, const At& at) {
        const double area = cross(p[1] - p[0], p[2] - p[0]);
        if (area == 0)
            return;
        const auto clampX = [&](double x) { return std::clamp(static_cast<int>(x), 0, m_width - 1); };
        const auto clampY = [&](double y) { return std::clamp(static_cast<int>(y), 0, m_height - 1); };
        const int left = clampX(std::min({p[0].x(), p[1].x(), p[2].x()}) - 1);
        const int right = clampX(std::max({p[0].x(), p[1].x(), p[2].x()}) + 1);
        const int top = clampY(std::min({p[0].y(), p[1].y(), p[2].y()}) - 1);
        const int bottom = clampY(std::max({p[0].y(), p[1].y(), p[2].y()}) + 1);
        for (int y = top; y <= bottom; ++y)
            for (int x = left; x <= right; ++x) {
                const Eigen::Vector3d here(x + 0.5, y + 0.5, 0);
                const double b = cross(here - p[0], p[2] - p[0]) / area;
                const double c = cross(p[1] - p[0], here - p[0]) / area;
                if (b < 0 || c < 0 || b + c > 1)
                    continue;
                const double depth = p[0].z() + b * (p[1].z() - p[0].z()) + c * (p[2].z() - p[0].z());
                at(static_cast<std::size_t>(y) * m_width + x, static_cast<float>(depth));
            }
    }

    void paint(const std::array<Eigen::Vector3d, 3>& corners, const Eigen::Vector3f& colour) {
        eachPixel(corners, [&](std::size_t pixel, float depth) {
            if (depth >= m_depth[pixel])
                return;
            m_depth[pixel] = depth;
            m_colour[pixel] << colour, 1;
        });
    }

    /// Lays glass over what is behind it, and under what is before it.
    void glaze(const std::array<Eigen::Vector3d, 3>& corners, const Eigen::Vector3f& colour, float opacity) {
        eachPixel(corners, [&](std::size_t pixel, float depth) {
            if (depth > m_depth[pixel])
                return;
            Eigen::Vector4f glass;
            glass << opacity * colour, opacity;
            m_colour[pixel] = glass + (1 - opacity) * m_colour[pixel];
        });
    }

    [[nodiscard]] SmallPicture averaged() const {
        SmallPicture picture{m_width / finer, m_height / finer, {}};
        picture.rgba.reserve(static_cast<std::size_t>(picture.width) * picture.height * 4);
        for (int y = 0; y < picture.height; ++y)
            for (int x = 0; x < picture.width; ++x) {
                Eigen::Vector4f sum = Eigen::Vector4f::Zero();
                for (int v = 0; v < finer; ++v)
                    for (int u = 0; u < finer; ++u)
                        sum += m_colour[static_cast<std::size_t>(y * finer + v) * m_width + x * finer + u];
                const float opacity = sum[3] / (finer * finer);
                const float share = sum[3] > 0 ? 255 / sum[3] : 0;
                for (int k = 0; k < 3; ++k)
                    picture.rgba.push_back(static_cast<std::uint8_t>(std::lround(share * sum[k])));
                picture.rgba.push_back(static_cast<std::uint8_t>(std::lround(255 * opacity)));
            }
        return picture;
    }

private:
    static double cross(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
        return a.x() * b.y() - a.y() * b.x();
    }

    int m_width;
    int m_height;
    std::vector<Eigen::Vector4f> m_colour; ///< premultiplied
    std::vector<float> m_depth;
};

Eigen::Vector3f colourOf(Rgb rgb) {
    const auto unit = rgb.unit();
    return Eigen::Vector3d(unit.data()).cast<float>();
}

/// How bright a face is, by the lights of the views; the normal is in the camera's axes.
float brightness(const Eigen::Vector3d& normal) {
    double sum = 0.16;
    for (const auto& [way, strength] : {std::pair{Eigen::Vector3d(-0.5, 0.8, 1.0), 0.78},
                                        {Eigen::Vector3d(0.9, 0.2, 0.9), 0.36},
                                        {Eigen::Vector3d(0, -0.9, 0.4), 0.18}})
        sum += strength * std::max(0.0, normal.dot(way.normalized()));
    return static_cast<float>(std::min(1.0, sum));
}

void paintSurface(Canvas& canvas, const IndexedMesh& mesh, std::span<const Rgb> faceColours, Rgb plain,
                  const Camera& camera, ViewSize view) {
    std::vector<Eigen::Vector3d> seen(static_cast<std::size_t>(mesh.vertexCount()));
    for (int v = 0; v < mesh.vertexCount(); ++v)
        seen[static_cast<std::size_t>(v)] = camera.project(mesh.point(v), view);
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const Eigen::Vector3d normal =
            (mesh.corner(f, 1) - mesh.corner(f, 0)).cross(mesh.corner(f, 2) - mesh.corner(f, 0)).normalized();
        if (normal.dot(camera.backwards()) <= 0)
            continue; // the far side of a closed surface is never seen
        const Rgb colour = faceColours.empty() ? plain : faceColours[static_cast<std::size_t>(f)];
        const auto corner = [&](int k) { return seen[static_cast<std::size_t>(mesh.F(f, k))]; };
        canvas.paint({corner(0), corner(1), corner(2)},
                     brightness(camera.turn.conjugate() * normal) * colourOf(colour));
    }
}

void glazePlane(Canvas& canvas, const PlaneRectangle& plane, const SceneColours& colours,
                const Camera& camera, ViewSize view) {
    std::array<Eigen::Vector3d, 4> corner;
    for (std::size_t k = 0; k < 4; ++k)
        corner[k] = camera.project(plane.at(k == 0 || k == 3 ? -1 : 1, k < 2 ? -1 : 1), view);
    const Eigen::Vector3f colour = colourOf(colours.plane);
    const auto opacity = static_cast<float>(colours.planeOpacity);
    canvas.glaze({corner[0], corner[1], corner[2]}, colour, opacity);
    canvas.glaze({corner[0], corner[2], corner[3]}, colour, opacity);
    const double half = 0.6 * finer; // of the outline, pixels
    for (std::size_t k = 0; k < 4; ++k) {
        const Eigen::Vector3d& a = corner[k];
        const Eigen::Vector3d& b = corner[(k + 1) % 4];
        Eigen::Vector3d across(a.y() - b.y(), b.x() - a.x(), 0);
        if (across.norm() == 0)
            continue;
        across *= half / across.norm();
        canvas.paint({a - across, b - across, b + across}, colour);
        canvas.paint({a - across, b + across, a + across}, colour);
    }
}

} // namespace

SmallPicture smallPicture(const IndexedMesh& mesh, std::span<const Rgb> faceColours,
                          const PlaneRectangle& plane, const SceneColours& colours, const Camera& camera,
                          int width, int height) {
    Canvas canvas(width * finer, height * finer);
    const ViewSize view{static_cast<double>(width) * finer, static_cast<double>(height) * finer};
    Camera still = camera;
    still.perspective = false;
    paintSurface(canvas, mesh, faceColours, colours.part, still, view);
    glazePlane(canvas, plane, colours, still, view);
    return canvas.averaged();
}

} // namespace moldwright::scene
