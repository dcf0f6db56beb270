// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/importance.h"

#include <algorithm>

namespace moldwright {

namespace {

void add(ImportantRegion& region, int face, double weight) {
    region.faces.push_back(face);
    region.weights.push_back(weight);
}

} // namespace

ImportantRegion heavier(const ImportantRegion& region, const std::vector<int>& faces) {
    ImportantRegion result{region.name, {}, {}, region.keepWithin};
    std::size_t i = 0;
    const auto keepBefore = [&](auto isBefore) {
        for (; i < region.faces.size() && isBefore(region.faces[i]); ++i)
            add(result, region.faces[i], region.weights[i]);
    };
    for (const int face : faces) {
        keepBefore([&](int old) { return old < face; });
        const bool known = i < region.faces.size() && region.faces[i] == face;
        add(result, face, known ? std::min(2 * region.weights[i++], mostWeight) : 2);
    }
    keepBefore([](int) { return true; });
    return result;
}

ImportantRegion lighter(const ImportantRegion& region, const std::vector<int>& faces) {
    ImportantRegion result{region.name, {}, {}, region.keepWithin};
    for (std::size_t i = 0; i < region.faces.size(); ++i) {
        const bool erased = std::binary_search(faces.begin(), faces.end(), region.faces[i]);
        const double weight = erased ? region.weights[i] / 2 : region.weights[i];
        if (!erased || weight > 1)
            add(result, region.faces[i], weight);
    }
    return result;
}

ImportantRegion weighing(ImportantRegion region, double weight) {
    std::fill(region.weights.begin(), region.weights.end(), std::clamp(weight, 1.0, mostWeight));
    return region;
}

double heaviest(const ImportantRegion& region) {
    return region.weights.empty() ? 1 : *std::max_element(region.weights.begin(), region.weights.end());
}

std::vector<double> faceWeights(const std::vector<ImportantRegion>& regions, int faceCount) {
    std::vector<double> weights;
    for (const ImportantRegion& region : regions) {
        if (heaviest(region) <= 1)
            continue;
        weights.resize(static_cast<std::size_t>(faceCount), 1);
        for (std::size_t i = 0; i < region.faces.size(); ++i) {
            double& here = weights[static_cast<std::size_t>(region.faces[i])];
            here = std::max(here, region.weights[i]);
        }
    }
    return weights;
}

std::vector<KeptRegion> keptRegions(const std::vector<ImportantRegion>& regions) {
    std::vector<KeptRegion> kept;
    for (const ImportantRegion& region : regions)
        kept.push_back({region.name, region.faces, region.keepWithin});
    return kept;
}

bool keepsWithin(const ImportantRegion& region, const RegionMeasure& measure) {
    return region.keepWithin <= 0 || measure.maxDistance <= region.keepWithin;
}

bool weighAlike(const std::vector<ImportantRegion>& a, const std::vector<ImportantRegion>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
        return one.faces == other.faces && one.weights == other.weights;
    });
}

} // namespace moldwright
