// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/offscreen/picture.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace moldwright::scene {

namespace {

constexpr int finer = 2;

/// A VTK window that draws in an EGL context.
class OffscreenWindow {
public:
    OffscreenWindow(const EglContext& context, int width, int height) : m_context(context) {
        observe(vtkCommand::WindowMakeCurrentEvent, [](vtkObject*, unsigned long, void* self, void*) {
            static_cast<OffscreenWindow*>(self)->m_context.makeCurrent();
        });
        observe(vtkCommand::WindowIsCurrentEvent, [](vtkObject*, unsigned long, void* self, void*) {
            auto& window = *static_cast<OffscreenWindow*>(self);
            window.m_window->SetIsCurrent(window.m_context.isCurrent());
        });
        m_window->SetOwnContext(0);
        m_window->SetFrameBlitModeToNoBlit();
        m_window->SetSize(width, height);
        m_window->SetReadyForRendering(true);
    }
    ~OffscreenWindow() {
        m_window->Finalize();
        m_window->RemoveAllObservers();
    }
    OffscreenWindow(const OffscreenWindow&) = delete;
    OffscreenWindow& operator=(const OffscreenWindow&) = delete;

    [[nodiscard]] vtkGenericOpenGLRenderWindow* vtk() const { return m_window; }

private:
    void observe(unsigned long event, void (*function)(vtkObject*, unsigned long, void*, void*)) {
        vtkNew<vtkCallbackCommand> command;
        command->SetClientData(this);
        command->SetCallback(function);
        m_window->AddObserver(event, command);
    }

    const EglContext& m_context;
    vtkNew<vtkGenericOpenGLRenderWindow> m_window;
};

/// Each pixel the mean of finer × finer of `pixels`, whose rows run from bottom to top.
Picture halved(const vtkUnsignedCharArray& pixels, int width, int height) {
    Picture picture{width, height, {}};
    picture.rgb.reserve(3 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    auto& source = const_cast<vtkUnsignedCharArray&>(pixels); // VTK 9.1 reads through non-const members
    for (int y = height - 1; y >= 0; --y)
        for (int x = 0; x < width; ++x)
            for (int channel = 0; channel < 3; ++channel) {
                int sum = 0;
                for (int dy = 0; dy < finer; ++dy)
                    for (int dx = 0; dx < finer; ++dx)
                        sum += source.GetValue(
                            3 * (static_cast<vtkIdType>(finer * y + dy) * finer * width + finer * x + dx) +
                            channel);
                picture.rgb.push_back(static_cast<std::uint8_t>(sum / (finer * finer)));
            }
    return picture;
}

} // namespace

Picture renderPicture(Scene& scene, const EglContext& context, const Eigen::Vector3d& from, int width,
                      int height) {
    const OffscreenWindow window(context, finer * width, finer * height);
    scene.showIn(window.vtk(), false);
    const ViewSize view{static_cast<double>(finer * width), static_cast<double>(finer * height)};
    scene.arrange(fitted(lookingFrom({}, from), scene.outline(), view), view);
    window.vtk()->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    window.vtk()->GetPixelData(0, 0, finer * width - 1, finer * height - 1, 0, pixels.Get(), 0);
    return halved(*pixels, width, height);
}

Picture cropped(const Picture& picture, Rgb background) {
    Eigen::AlignedBox2i drawn;
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            if (picture.at(x, y) != background)
                drawn.extend(Eigen::Vector2i(x, y));
    if (drawn.isEmpty())
        return picture;
    const int margin = picture.width / 100;
    const Eigen::Vector2i from = (drawn.min().array() - margin).max(0);
    const int right = std::min(drawn.max().x() + margin, picture.width - 1);
    const int bottom = std::min(drawn.max().y() + margin, picture.height - 1);
    Picture part{right - from.x() + 1, bottom - from.y() + 1, {}};
    for (int y = from.y(); y <= bottom; ++y)
        for (int x = from.x(); x <= right; ++x) {
            const Rgb colour = picture.at(x, y);
            part.rgb.insert(part.rgb.end(), {colour.r, colour.g, colour.b});
        }
    return part;
}

std::string pngBytes(const Picture& picture) {
    vtkNew<vtkImageData> image;
    image->SetDimensions(picture.width, picture.height, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const Rgb colour = picture.at(x, picture.height - 1 - y);
            auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
            pixel[0] = colour.r;
            pixel[1] = colour.g;
            pixel[2] = colour.b;
        }
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputData(image);
    writer->WriteToMemoryOn();
    writer->Write();
    vtkUnsignedCharArray* bytes = writer->GetResult();
    return {reinterpret_cast<const char*>(bytes->GetPointer(0)),
            static_cast<std::size_t>(bytes->GetNumberOfTuples())};
}

} // namespace moldwright::scene
