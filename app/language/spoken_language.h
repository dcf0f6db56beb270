// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QTranslator>

namespace moldwright {

/// The program speaks a language as long as this lives; English where there is no translation. Precondition:
/// there is an application.
class SpokenLanguage {
public:
    explicit SpokenLanguage(const QLocale& locale);
    ~SpokenLanguage();
    SpokenLanguage(const SpokenLanguage&) = delete;
    SpokenLanguage& operator=(const SpokenLanguage&) = delete;

private:
    QTranslator m_own;
    QTranslator m_ofQt;
};

} // namespace moldwright
