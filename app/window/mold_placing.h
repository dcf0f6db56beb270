// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "window/live_sketch.h"

#include <QObject>
#include <QString>

#include <memory>
#include <vector>

namespace moldwright {

class Document;

/// One feature of the mold that can be placed, with its copies in all cavities.
struct PlacedRow {
    PlacedFeature stands; ///< where the newest answer has it
    bool byHand = false;
    std::vector<const MoldFeature*> copies; ///< of the sketch
    const ThinSteel* thinnest = nullptr;    ///< about it; null where nothing is near
    double asked = 0;                       ///< mm of steel there

    [[nodiscard]] bool failing() const { return thinnest != nullptr && thinnest->thickness < asked - 1e-3; }
};

/// Where the features of the document's mold stand: answers that follow every edit, and edits by hand.
class MoldPlacing : public QObject {
    Q_OBJECT
public:
    explicit MoldPlacing(Document& document, QObject* parent = nullptr);

    /// Answers are only sought while they are wanted.
    void setWanted(bool wanted);
    /// Asks again where the project calls for it.
    void follow();

    /// The newest answer that could be given for this cast; null before the first. It may be of other
    /// settings for the moment, or for as long as these cannot be built.
    [[nodiscard]] const MoldSketch* sketch() const;
    /// Why there is none for the settings as they stand, for people; empty where there is, or none is known.
    [[nodiscard]] QString refusal() const;
    /// All that can be placed, by kind and number.
    [[nodiscard]] const std::vector<PlacedRow>& rows() const { return m_rows; }
    /// null for none.
    [[nodiscard]] const PlacedRow* row(Placeable kind, int number) const;
    /// Where the settings in view put a feature: by hand, or where the newest answer has it.
    [[nodiscard]] Eigen::Vector2d placeInView(const PlacedRow& row) const;

    /// A preview is no step yet. Pieces of one drag become one step by `mergeKey`.
    void place(const PlacedFeature& feature, const QString& mergeKey, bool preview);
    /// One step for all of them: kinds and numbers.
    void placeAutomatically(const std::vector<std::pair<Placeable, int>>& features);
    void placeAllAutomatically();

Q_SIGNALS:
    /// Another answer is there.
    void changed();

private:
    void take(const std::shared_ptr<const SketchAnswer>& answer);
    void listRows();

    Document& m_document;
    bool m_wanted = false;
    SketchRequest m_asked;
    std::shared_ptr<const SketchAnswer> m_newest; ///< also a refusal
    std::shared_ptr<const SketchAnswer> m_good;   ///< the newest with a sketch
    std::vector<PlacedRow> m_rows;                ///< of m_good
    LiveSketch m_live;
};

/// "Key 2".
[[nodiscard]] QString featureName(Placeable kind, int number);
/// What steel is between: "Key 2 – cavity 1".
[[nodiscard]] QString steelEnds(const ThinSteel& steel);
/// Where a feature stands, with the steel there: "2.1 mm of steel to cavity 1, 3 asked for".
[[nodiscard]] QString steelWords(const PlacedRow& row);

} // namespace moldwright
