// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/program.h"

int main(int argc, char** argv) {
    return moldwright::runWindow(argc, argv);
}
