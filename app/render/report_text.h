// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace moldwright::render {

/// Texts of a report in its language: ReportText::tr().
class ReportText {
    Q_DECLARE_TR_FUNCTIONS(Report)
};

} // namespace moldwright::render
