// SPDX-License-Identifier: AGPL-3.0-or-later
// moldwright-samples FOLDER [NAME …]: makes the bundled sample shapes anew, all or the named ones, and their
// catalogue.
#include "catalogue.h"

#include <iostream>

int main(int count, char** arguments) {
    using namespace moldwright;
    if (count < 2) {
        std::cerr << "Usage: moldwright-samples FOLDER [NAME …]\n";
        return 2;
    }
    const std::filesystem::path folder = arguments[1];
    auto done = samples::writeSamples(folder, {arguments + 2, arguments + count});
    if (done)
        done = samples::writeCatalogue(folder);
    if (done)
        return 0;
    std::cerr << done.error().english() << '\n';
    return done.error().code == ErrorCode::Usage ? 2 : 3;
}
