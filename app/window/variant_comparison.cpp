// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/variant_comparison.h"

#include "project/variants.h"

#include <algorithm>
#include <utility>

namespace moldwright {

VariantComparison::VariantComparison(QObject* parent)
    : QObject(parent), m_thread(QStringLiteral("variants")) {
    connect(&m_analysis, &LiveAnalysis::answered, this, [this](const auto& answer) {
        m_answer = answer;
        Q_EMIT changed();
    });
}

void VariantComparison::follow(const Project& project) {
    const std::string before = m_project.variantName;
    const auto number = compared();
    const bool renamed =
        number && !variantNamed(project, m_compared) && variantCount(project) == variantCount(m_project);
    m_project = project;
    if (renamed)
        m_compared = variantAt(project, *number).variantName;
    if (!m_compared.empty() && m_compared == project.variantName)
        m_compared = before;
    if (!compared())
        m_compared.clear();
    forgetOld();
    ask();
    measureMissing();
}

void VariantComparison::forgetOld() {
    // They hold on to casts that nothing else may need any more.
    std::erase_if(m_known, [&](const auto& known) {
        for (std::size_t i = 0; i < variantCount(m_project); ++i)
            if (known->key == keyOf(i))
                return false;
        return true;
    });
}

VariantComparison::Key VariantComparison::keyOf(std::size_t number) const {
    const Variant& variant = variantAt(m_project, number);
    return {m_project.part, variant.cast, variant.furtherParts, variant.mold};
}

void VariantComparison::compareWith(std::optional<std::size_t> number) {
    m_compared = number && *number != m_project.place ? variantAt(m_project, *number).variantName : "";
    ask();
    Q_EMIT changed();
}

std::optional<std::size_t> VariantComparison::compared() const {
    const auto number = m_compared.empty() ? std::nullopt : variantNamed(m_project, m_compared);
    return number == m_project.place ? std::nullopt : number;
}

const Variant* VariantComparison::other() const {
    const auto number = compared();
    return number ? &variantAt(m_project, *number) : nullptr;
}

void VariantComparison::ask() {
    const Variant* shown = other();
    if (!shown || !m_project.part) {
        m_asked = {};
        m_answer.reset();
        return;
    }
    const CastResult* cast = shown->cast.get();
    const AnalysisRequest request{cast ? cast->mesh : m_project.part, shown->state,
                                  shown->design.draftDegrees, cast ? cast->labels : SideLabels()};
    if (request.mesh == m_asked.mesh && request.state == m_asked.state &&
        request.draftDegrees == m_asked.draftDegrees)
        return;
    m_asked = request;
    m_analysis.ask(request);
}

const AnalysisAnswer* VariantComparison::answer() const {
    return m_answer && m_answer->request.mesh == m_asked.mesh ? m_answer.get() : nullptr;
}

const VariantFigures* VariantComparison::figures(std::size_t number) const {
    const Key key = keyOf(number);
    const auto found = std::ranges::find_if(m_known, [&](const auto& known) { return known->key == key; });
    return found != m_known.end() ? &(*found)->figures : nullptr;
}

void VariantComparison::setWanted(bool wanted) {
    if (wanted == m_wanted)
        return;
    m_wanted = wanted;
    measureMissing();
}

std::optional<VariantComparison::Key> VariantComparison::firstMissing() const {
    if (m_project.part && (m_wanted || !m_project.others.empty()))
        for (std::size_t i = 0; i < variantCount(m_project); ++i)
            if (variantAt(m_project, i).cast && !figures(i))
                return keyOf(i);
    return std::nullopt;
}

void VariantComparison::measureMissing() {
    if (m_measuring)
        return; // it comes back here once that is done
    const std::optional<Key> key = firstMissing();
    if (!key)
        return;
    m_measuring = true;
    m_thread.post([this, key = *key] {
        Variant variant;
        variant.cast = key.cast;
        variant.furtherParts = key.furtherParts;
        variant.mold = key.mold;
        const auto known = std::make_shared<const Known>(Known{key, variantFigures(*key.part, variant)});
        QMetaObject::invokeMethod(this, [this, known] {
            m_measuring = false;
            m_known.push_back(known);
            measureMissing();
            Q_EMIT changed();
        });
    });
}

} // namespace moldwright
