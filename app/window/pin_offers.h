// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "pins/suggested_pins.h"
#include "scene/lasso.h"
#include "window/live_ranks.h"

#include <QObject>
#include <QString>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace moldwright {

class Background;
class Document;

/// Points of the part that are worth pinning to the plane: searched for once, ranked anew as the plane moves,
/// and taken one by one or together.
class PinOffers : public QObject {
    Q_OBJECT
public:
    static constexpr int fewest = 20, most = 60;

    PinOffers(Document& document, Background& background, QObject* parent = nullptr);

    /// Looks for them in the background. Precondition: that is not busy.
    void search();
    /// Asks for other ranks where the project calls for them.
    void follow();

    /// Whether they are known for the document's part.
    [[nodiscard]] bool known() const;
    [[nodiscard]] int count() const { return m_count; }
    /// Within fewest and most.
    void setCount(int count);
    /// The best count() at the plane, best first, without those taken; none while they are not known.
    [[nodiscard]] std::vector<SuggestedPin> inView() const;

    // Each is one undo step.
    /// Takes one of inView().
    void accept(int pin);
    /// Takes all in view that are ends of limbs.
    void acceptTips();
    /// Takes all in view that are seen inside the lasso; false where there are none.
    bool acceptIn(const scene::Lasso& lasso);

Q_SIGNALS:
    /// Others are in view, or in another order.
    void changed();
    /// A search has ended well.
    void found();
    void failed(const moldwright::Error& error);

private:
    bool acceptWhere(const std::function<bool(const SuggestedPin&)>& wanted, const QString& words);
    void take(const RankRequest& request, const std::shared_ptr<const PinSuggestions>& ranked);

    Document& m_document;
    Background& m_background;
    std::shared_ptr<const PinSuggestions> m_found;  ///< as found
    std::shared_ptr<const PinSuggestions> m_ranked; ///< the same, ranked as answered last
    SharedMesh m_part;                              ///< that they were found for
    std::optional<RankRequest> m_asked;             ///< the last one
    int m_count = 40;
    LiveRanks m_ranks;
};

} // namespace moldwright
