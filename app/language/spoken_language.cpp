// SPDX-License-Identifier: AGPL-3.0-or-later
#include "language/spoken_language.h"

#include <QCoreApplication>
#include <QLibraryInfo>

namespace moldwright {

using namespace Qt::StringLiterals;

SpokenLanguage::SpokenLanguage(const QLocale& locale) {
    if (m_own.load(locale, u"moldwright"_s, u"_"_s, u":/i18n"_s))
        QCoreApplication::installTranslator(&m_own);
    if (m_ofQt.load(locale, u"qtbase"_s, u"_"_s, QLibraryInfo::path(QLibraryInfo::TranslationsPath)))
        QCoreApplication::installTranslator(&m_ofQt);
}

SpokenLanguage::~SpokenLanguage() {
    QCoreApplication::removeTranslator(&m_own);
    QCoreApplication::removeTranslator(&m_ofQt);
}

} // namespace moldwright
