// SPDX-License-Identifier: AGPL-3.0-or-later
// Several designs of one part, of which one is worked on.
#include "project/variants.h"

#include "window/workbench.h"

namespace moldwright {

namespace {

QString nameOf(const Project& project, int variant) {
    return QString::fromStdString(variantAt(project, static_cast<std::size_t>(variant)).variantName);
}

} // namespace

void Workbench::chooseVariant(int variant) {
    const Project& now = m_document.committed();
    m_document.edit(tr("Variant %1").arg(nameOf(now, variant)),
                    withVariant(now, static_cast<std::size_t>(variant)));
}

void Workbench::walkVariants(int way) {
    const int count = static_cast<int>(variantCount(m_document.committed()));
    chooseVariant((static_cast<int>(m_document.committed().place) + way + count) % count);
}

void Workbench::duplicateVariant(int variant) {
    const Project& now = m_document.committed();
    const QString name = nameOf(now, variant);
    m_document.edit(tr("Duplicate %1").arg(name), withDuplicate(now, static_cast<std::size_t>(variant)));
    say(Standing::Done, tr("%1 is a copy of %2, and the current variant now.")
                            .arg(QString::fromStdString(project().variantName), name));
}

void Workbench::addVariant() {
    m_document.edit(tr("New variant"), withFreshVariant(m_document.committed()));
    say(Standing::Done, tr("%1 is a new variant, without pins and regions, and the current one now.")
                            .arg(QString::fromStdString(project().variantName)));
}

void Workbench::renameVariant(int variant, const QString& name) {
    const Project& now = m_document.committed();
    const auto number = static_cast<std::size_t>(variant);
    if (const auto taken = variantNamed(now, name.trimmed().toStdString()); taken && *taken != number) {
        say(Standing::Warning, tr("There is a variant %1 already. Take another name.").arg(name.trimmed()));
        return;
    }
    if (auto mold = m_molds.extract(variantAt(now, number).variantName)) {
        mold.key() = name.trimmed().toStdString();
        m_molds.insert(std::move(mold));
    }
    m_document.edit(tr("Rename"), withVariantName(now, number, name.toStdString()));
}

void Workbench::removeVariant(int variant) {
    const Project& now = m_document.committed();
    m_document.edit(tr("Remove %1").arg(nameOf(now, variant)),
                    withoutVariant(now, static_cast<std::size_t>(variant)));
}

} // namespace moldwright
