// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "project/variant_figures.h"
#include "window/live_analysis.h"
#include "window/work_thread.h"

#include <QObject>

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace moldwright {

/// Keeps up, on threads of its own, what is known of the variants beside the current one's analysis: the
/// figures of all, and one that is shown beside the current one, ready to be drawn.
class VariantComparison : public QObject {
    Q_OBJECT
public:
    explicit VariantComparison(QObject* parent = nullptr);

    /// The project is another; what was compared stays so under its name. Where it has become the current
    /// one, the one that was current before is compared with it.
    void follow(const Project& project);

    /// Shows a variant beside the current one; none: no longer.
    void compareWith(std::optional<std::size_t> number);
    /// Its number; none where nothing is compared.
    [[nodiscard]] std::optional<std::size_t> compared() const;
    /// That variant; null where nothing is compared.
    [[nodiscard]] const Variant* other() const;
    /// The newest analysis of its cast, or of the part while it has none; null while it is not made.
    [[nodiscard]] const AnalysisAnswer* answer() const;

    /// Figures of a variant; null while they are measured, or where it has no cast.
    [[nodiscard]] const VariantFigures* figures(std::size_t number) const;
    /// Whether the figures are wanted where there is one variant only.
    void setWanted(bool wanted);

Q_SIGNALS:
    void changed();

private:
    /// What figures follow from.
    struct Key {
        SharedMesh part;
        std::shared_ptr<const CastResult> cast;
        std::vector<TrayPart> furtherParts;
        MoldSettings mold;
        bool operator==(const Key&) const = default;
    };
    struct Known {
        Key key; ///< with a cast
        VariantFigures figures;
    };

    [[nodiscard]] Key keyOf(std::size_t number) const;
    void forgetOld();
    void ask();
    [[nodiscard]] std::optional<Key> firstMissing() const;
    void measureMissing();

    Project m_project;
    std::string m_compared; ///< name of the variant; empty for none
    AnalysisRequest m_asked;
    std::shared_ptr<const AnalysisAnswer> m_answer;
    bool m_wanted = false;
    std::vector<std::shared_ptr<const Known>> m_known;
    bool m_measuring = false; ///< one of them
    LiveAnalysis m_analysis;
    WorkThread m_thread;
};

} // namespace moldwright
