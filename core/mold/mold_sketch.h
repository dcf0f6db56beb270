// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mold/block.h"
#include "mold/mold.h"

#include <memory>
#include <string>
#include <vector>

namespace moldwright {

/// Where everything of a mold stands and the steel between it, before its halves are built. The same code
/// finds it that builds the mold, so the mold has just this, but for what the joints move by hundredths of a
/// channel's width where rounding asks for it.
struct MoldSketch {
    MoldSettings settings;
    Block block;
    std::vector<MoldFeature> features;
    std::vector<ThinSteel> steel;        ///< by pair of features, thinnest first; 0 where they meet
    std::vector<PlanShape> partingLines; ///< of all cavities, mm, mold's frame
    double trappedAir = 0;               ///< mm³ that no vent serves
    /// As those of the mold.
    Eigen::Isometry3d partToMold = Eigen::Isometry3d::Identity();
    Eigen::Vector3d shrinkFactors = Eigen::Vector3d::Ones();
};

/// Answers where the features of one mold would stand if some of them were put elsewhere, while one is
/// dragged: what does not depend on that is prepared once.
class MoldSketcher {
public:
    /// Errors: as those of buildMold() for casts and layout. Takes about as long as certificates of the
    /// casts.
    [[nodiscard]] static Result<MoldSketcher> prepared(const Tray& tray, double draftDegrees,
                                                       const MoldSettings& settings);
    ~MoldSketcher();
    MoldSketcher(MoldSketcher&&) noexcept;
    MoldSketcher& operator=(MoldSketcher&&) noexcept;

    /// Whether these settings differ from those it was prepared for at most in what is placed by hand.
    [[nodiscard]] bool serves(const MoldSettings& settings) const;

    /// The mold with these placed by hand instead. What stands in another's way is marked by its steel, 0 mm.
    /// Errors: Impossible, where something cannot stand where it was put, or all else has no room then.
    [[nodiscard]] Result<MoldSketch> sketch(const PlacedFeatures& placed);

private:
    struct State;
    explicit MoldSketcher(std::unique_ptr<State> state);

    std::unique_ptr<State> m_state;
};

/// What hollows of a kind are called where steel is told of.
[[nodiscard]] const char* steelName(Placeable kind);

/// The thinnest steel about a feature, of those given thinnest first; null where none is near.
[[nodiscard]] const ThinSteel* thinnestAbout(const std::vector<ThinSteel>& steel, Placeable kind, int number);

/// What the settings ask for between those two, mm.
[[nodiscard]] double steelAsked(const ThinSteel& steel, const MoldSettings& settings);

} // namespace moldwright
