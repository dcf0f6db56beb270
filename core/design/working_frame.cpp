// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/working_frame.h"

#include "mesh/measures.h"

namespace moldwright {

WorkingFrame::WorkingFrame(const IndexedMesh& part, const MoldState& state) {
    const Eigen::AlignedBox3d box = boundingBox(part);
    m_centre = box.center();
    m_scale = box.diagonal().norm();
    const PartingPlane scaled{state.plane.normal,
                              (state.plane.offset - state.plane.normal.dot(m_centre)) / m_scale};
    const Eigen::Isometry3d frame = planeFrame(scaled);
    m_rotation = frame.linear();
    m_shift = frame.translation();
}

Eigen::Vector3d WorkingFrame::toWork(const Eigen::Vector3d& x) const {
    return m_rotation * ((x - m_centre) / m_scale) + m_shift;
}

Eigen::Vector3d WorkingFrame::toPart(const Eigen::Vector3d& x) const {
    return m_centre + m_scale * (m_rotation.transpose() * (x - m_shift));
}

IndexedMesh WorkingFrame::toWork(const IndexedMesh& part) const {
    IndexedMesh work = part;
    for (int v = 0; v < part.vertexCount(); ++v)
        work.V.row(v) = toWork(part.point(v)).transpose();
    return work;
}

IndexedMesh WorkingFrame::toPart(const IndexedMesh& work) const {
    IndexedMesh part = work;
    for (int v = 0; v < work.vertexCount(); ++v)
        part.V.row(v) = toPart(work.point(v)).transpose();
    return part;
}

Directions WorkingFrame::directionsToWork(const Directions& d) const {
    return {m_rotation * d.d1, m_rotation * d.d2};
}

} // namespace moldwright
