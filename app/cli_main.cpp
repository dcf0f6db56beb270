// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/program.h"

int main(int argc, char** argv) {
    return moldwright::cli::runProgram(argc, argv);
}
