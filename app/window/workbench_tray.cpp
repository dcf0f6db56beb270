// SPDX-License-Identifier: AGPL-3.0-or-later
// Different parts in one mold: read from project files, counted, removed.
#include "mold/mold_sketch.h"
#include "project/further_parts.h"
#include "project/variants.h"
#include "window/sentence.h"
#include "window/workbench.h"

#include <QFileInfo>

namespace moldwright {

namespace {

QString nameOf(const TrayPart& part) {
    return QString::fromStdString(part.name);
}

Project withParts(Project project, const std::vector<TrayPart>& parts) {
    for (const TrayPart& part : parts)
        project = withFurtherPart(std::move(project), part);
    return project;
}

/// Why no mold can be built of these parts, as far as that is known before it is.
std::optional<Error> refusalOf(const Project& project) {
    if (!project.cast)
        return std::nullopt;
    Result<MoldSketcher> sketcher =
        MoldSketcher::prepared(trayOf(project, project.name), project.cast->draftDegrees, project.mold);
    if (!sketcher)
        return sketcher.error();
    const Result<MoldSketch> sketch = sketcher->sketch(project.mold.placed);
    return sketch ? std::nullopt : std::optional(sketch.error());
}

} // namespace

void Workbench::addPartsToMold(const QStringList& files) {
    const Project from = m_document.committed();
    const QString reading = files.size() == 1 ? tr("Reading %1").arg(QFileInfo(files.front()).fileName())
                                              : tr("Reading %1 parts").arg(files.size());
    m_background.start(reading, [=, this](const Task& task) -> Background::Finish {
        std::vector<TrayPart> parts;
        for (const QString& file : files) {
            const Project sofar = withParts(from, parts);
            Result<TrayPart> part = readTrayPart(file.toStdString(), namesTaken(trayOf(sofar, sofar.name)));
            if (!part)
                return [=, this, error = part.error()] { complain(error, reading); };
            if (task.stopped())
                return [=, this] { say(Standing::Info, tr("%1 was stopped.").arg(reading)); };
            parts.push_back(*std::move(part));
        }
        const std::optional<Error> refusal = refusalOf(withParts(from, parts));
        return [=, this] {
            m_document.edit(parts.size() == 1 ? tr("Add %1 to the mold").arg(nameOf(parts.front()))
                                              : tr("Add %1 parts to the mold").arg(parts.size()),
                            withParts(m_document.committed(), parts));
            for (const TrayPart& part : parts)
                say(Standing::Done, tr("%1 has a cavity in the mold now.").arg(nameOf(part)));
            tellOfMold(refusal);
            Q_EMIT partOfMoldAdded(static_cast<int>(project().furtherParts.size()) - 1);
        };
    });
}

void Workbench::tellOfMold(const std::optional<Error>& refusal) {
    if (!refusal)
        return;
    const QString text = sentence(refusal->message);
    say(Standing::Warning, text);
    const auto [headline, rest] = headAndRest(text);
    Q_EMIT advised({Standing::Warning, headline, rest, QStringLiteral("undo")});
}

void Workbench::readPartAgain(int part) {
    const Project from = m_document.committed();
    const auto number = static_cast<std::size_t>(part);
    const TrayPart known = from.furtherParts.at(number);
    const QString reading = tr("Reading %1").arg(QFileInfo(QString::fromStdString(known.source)).fileName());
    m_background.start(reading, [=, this](const Task&) -> Background::Finish {
        const Result<TrayPart> read = readTrayPart(known.source, {});
        if (!read)
            return [=, this, error = read.error()] { complain(error, reading); };
        const std::shared_ptr<const CertifiedCast> cast = read->cast;
        const std::optional<Error> refusal = refusalOf(withFurtherCast(from, number, cast));
        return [=, this] {
            const Project after = withFurtherCast(m_document.committed(), number, cast);
            const bool same = after == m_document.committed();
            m_document.edit(tr("Read %1 again").arg(nameOf(known)), after);
            say(same ? Standing::Info : Standing::Done,
                same ? tr("%1 is in its file as it is in the mold.").arg(nameOf(known))
                     : tr("%1 was read again.").arg(nameOf(known)));
            tellOfMold(refusal);
        };
    });
}

void Workbench::renamePartOfMold(int part, const QString& name) {
    m_document.edit(tr("Rename"), withFurtherName(m_document.committed(), static_cast<std::size_t>(part),
                                                  name.trimmed().toStdString()));
}

void Workbench::countPartOfMold(int part, int cavities, bool preview) {
    const auto number = static_cast<std::size_t>(part);
    const Project& from = m_document.committed();
    const Project after = withFurtherCount(from, number, cavities);
    if (preview)
        m_document.preview(after);
    else
        m_document.edit(tr("Cavities of %1").arg(nameOf(from.furtherParts.at(number))), after,
                        QStringLiteral("tray-count-%1").arg(part));
}

void Workbench::removePartOfMold(int part) {
    const auto number = static_cast<std::size_t>(part);
    const Project& from = m_document.committed();
    m_document.edit(tr("Remove %1").arg(nameOf(from.furtherParts.at(number))),
                    withoutFurtherPart(from, number));
}

} // namespace moldwright
