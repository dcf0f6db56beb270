// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/value_scale.h"

#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStaticPointLocator.h>

#include <algorithm>
#include <cmath>

namespace moldwright::scene {

namespace {

Eigen::Vector3d middleOf(const IndexedMesh& mesh, int f) {
    return (mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3;
}

/// The value that 99 of 100 of the values above 0 do not exceed; 0 when there are none.
double nearlyLargest(std::span<const double> values) {
    std::vector<double> positive;
    std::ranges::copy_if(values, std::back_inserter(positive), [](double value) { return value > 0; });
    if (positive.empty())
        return 0;
    const auto at = positive.begin() + static_cast<std::ptrdiff_t>(99 * (positive.size() - 1) / 100);
    std::ranges::nth_element(positive, at);
    return *at;
}

} // namespace

int ValueScale::classOf(double value) const {
    return static_cast<int>(std::clamp(std::floor(value / step), 0.0, classes - 1.0));
}

Rgb ValueScale::colourOf(double value) const {
    return valueColours()[static_cast<std::size_t>(classOf(value))];
}

const std::array<Rgb, ValueScale::classes>& valueColours() {
    static constexpr std::array<Rgb, ValueScale::classes> colours = {
        Rgb::hex(0xF8F4E4), Rgb::hex(0xC6DEB4), Rgb::hex(0x86C7AE), Rgb::hex(0x48A0A8),
        Rgb::hex(0x2E6F96), Rgb::hex(0x254478), Rgb::hex(0x1B1F4B)};
    return colours;
}

std::array<Rgb, ValueScale::classes> steelColours(Rgb tooThin) {
    std::array<Rgb, ValueScale::classes> colours = valueColours();
    std::ranges::reverse(colours);
    colours.front() = tooThin;
    return colours;
}

ValueScale scaleFor(std::span<const double> values) {
    const double end = nearlyLargest(values);
    if (!(end > 0))
        return {};
    const double power = std::pow(10, std::floor(std::log10(end / ValueScale::classes)));
    for (const double round : {1.0, 2.0, 5.0})
        if (ValueScale::classes * round * power >= end)
            return {round * power};
    return {10 * power};
}

std::vector<int> nearestFaces(const IndexedMesh& from, const IndexedMesh& to) {
    const vtkNew<vtkPoints> middles;
    middles->SetDataTypeToDouble();
    middles->SetNumberOfPoints(from.faceCount());
    for (int f = 0; f < from.faceCount(); ++f)
        middles->SetPoint(f, middleOf(from, f).data());
    const vtkNew<vtkPolyData> cloud;
    cloud->SetPoints(middles);
    const vtkNew<vtkStaticPointLocator> nearest;
    nearest->SetDataSet(cloud);
    nearest->BuildLocator();
    std::vector<int> faces(static_cast<std::size_t>(to.faceCount()));
    for (int f = 0; f < to.faceCount(); ++f)
        faces[static_cast<std::size_t>(f)] =
            static_cast<int>(nearest->FindClosestPoint(middleOf(to, f).data()));
    return faces;
}

std::vector<double> carriedOver(const IndexedMesh& from, std::span<const double> values,
                                const IndexedMesh& to) {
    std::vector<double> carried;
    for (const int f : nearestFaces(from, to))
        carried.push_back(values[static_cast<std::size_t>(f)]);
    return carried;
}

} // namespace moldwright::scene
