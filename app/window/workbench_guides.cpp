// SPDX-License-Identifier: AGPL-3.0-or-later
// Pins and regions from and to files.
#include "window/workbench.h"

#include "exchange/mesh_file.h"
#include "project/edits.h"
#include "project/guide_files.h"

#include <QDir>

namespace moldwright {

template <class Read, class With>
void Workbench::importGuides(const QString& file, const QString& reading, Read read, With with,
                             const QString& edit, const QString& done) {
    const SharedMesh part = m_document.committed().part;
    m_background.start(reading, [=, this](const Task&) -> Background::Finish {
        const auto guides = read(file.toStdString(), *part);
        return [=, this] {
            if (!guides) {
                complain(guides.error(), reading);
                return;
            }
            m_document.edit(edit, with(m_document.committed(), *guides));
            say(Standing::Done, done.arg(guides->size()).arg(QDir::toNativeSeparators(file)));
        };
    });
}

void Workbench::exportGuides(const QString& file, const std::string& text, const QString& done) {
    const Result<void> written = writeFileAtomically(file.toStdString(), text);
    if (!written)
        complain(written.error(), tr("Export"));
    else
        say(Standing::Done, done.arg(QDir::toNativeSeparators(file)));
}

void Workbench::importPins(const QString& file) {
    importGuides(file, tr("Reading pins"), &readPins, &withPins, tr("Pins from a file"),
                 tr("%1 pins read from %2."));
}

void Workbench::exportPins(const QString& file) {
    exportGuides(file, pinsText(project().pins), tr("Pins written to %1."));
}

void Workbench::importWeights(const QString& file) {
    importGuides(file, tr("Reading regions"), &readWeights, &withImportance, tr("Regions from a file"),
                 tr("%1 regions read from %2."));
}

void Workbench::exportWeights(const QString& file) {
    exportGuides(file, weightsText(project().importance), tr("Regions written to %1."));
}

} // namespace moldwright
