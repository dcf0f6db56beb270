// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/task.h"
#include "mold/steel_map.h"
#include "scene/drawn_mesh.h"
#include "window/newest_job.h"

#include <QObject>

#include <array>
#include <memory>
#include <vector>

namespace moldwright {

/// The steel of both halves of a mold, ready to be drawn.
struct ShownSteel {
    std::shared_ptr<const Mold> mold;
    std::array<SteelMap, 2> maps;
    std::array<scene::SharedDrawnMesh, 2> halves;    ///< of the maps' surfaces
    std::array<std::vector<double>, 2> standInSteel; ///< per face of their stand-ins, where they have one
};

/// Measures the steel behind the walls of the mold in view, on a thread of its own. Only the newest mold
/// waits.
class LiveSteel : public QObject {
    Q_OBJECT
public:
    explicit LiveSteel(QObject* parent = nullptr);
    ~LiveSteel() override;

    /// That of a mold; null while it is measured.
    [[nodiscard]] const ShownSteel* of(const std::shared_ptr<const Mold>& mold);

Q_SIGNALS:
    void measured();

private:
    void work(const std::shared_ptr<const Mold>& mold);
    void take(const std::shared_ptr<const ShownSteel>& steel);

    std::shared_ptr<const Mold> m_asked;
    std::shared_ptr<const ShownSteel> m_shown;
    Task m_task; ///< cancelled when nobody waits any more
    NewestJob<std::shared_ptr<const Mold>> m_job;
};

} // namespace moldwright
