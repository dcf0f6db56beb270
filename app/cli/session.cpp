// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/session.h"

#include "exchange/mesh_file.h"

#include <iostream>

namespace moldwright::cli {

std::ostream& Session::out() const {
    static std::ostream nowhere(nullptr);
    return m_options.quiet || m_options.jsonFile == "-" ? nowhere : std::cout;
}

void Session::tell(const Message& message) const {
    std::cerr << "moldwright-cli: " << message.english() << '\n';
}

Result<void> Session::writeJson(const Json& json) const {
    if (m_options.jsonFile.empty())
        return {};
    if (m_options.jsonFile != "-")
        return writeFileAtomically(m_options.jsonFile, textOf(json));
    std::cout << textOf(json) << std::flush;
    if (!std::cout)
        return failure(ErrorCode::WriteFailed,
                       MW_TEXT("cli", "The JSON could not be written to standard output."));
    return {};
}

} // namespace moldwright::cli
