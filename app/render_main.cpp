// SPDX-License-Identifier: AGPL-3.0-or-later
#include "render/program.h"

int main(int argc, char** argv) {
    return moldwright::render::runProgram(argc, argv);
}
