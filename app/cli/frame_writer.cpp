// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/frame_writer.h"

#include "cli/state_options.h"
#include "exchange/mesh_file.h"

#include <string>

namespace moldwright::cli {

namespace {

std::string fileName(std::size_t number) {
    constexpr std::size_t digits = 4;
    const std::string text = std::to_string(number);
    return std::string(digits - std::min(digits, text.size()), '0') + text + ".ply";
}

} // namespace

FrameWriter::FrameWriter(std::filesystem::path folder) : m_folder(std::move(folder)) {}

FrameSink FrameWriter::sink() {
    return [this](const DesignFrame& frame) {
        if (m_written)
            m_written = write(frame);
    };
}

Result<void> FrameWriter::write(const DesignFrame& frame) {
    if (Result<void> made = makeFolder(m_folder); !made)
        return made;
    const std::string name = fileName(m_list.size() + 1);
    m_list.push_back({{"file", name},
                      {"stage", frame.stage},
                      {"step", frame.step},
                      {"plane", jsonOf(frame.state.plane)},
                      {"d1", jsonOf(frame.state.directions.d1)},
                      {"d2", jsonOf(frame.state.directions.d2)},
                      {"energy", frame.energy},
                      {"worst_draft_deg", frame.worstDraftDegrees},
                      {"violating_area_fraction", frame.violatingAreaFraction}});
    return writeMesh(m_folder / name, *frame.shape, MeshFormat::Ply);
}

Result<void> FrameWriter::finish() const {
    if (!m_written)
        return m_written;
    if (m_list.empty())
        return {};
    return writeFileAtomically(m_folder / "frames.json", textOf(Json{{"frames", m_list}}));
}

} // namespace moldwright::cli
