#!/usr/bin/env bash
# Runs once, when Gradescope builds the autograder's image: installs the packages, and compiles what every grading needs, so
# that ccache knows it. The image is Debian 12, or an Ubuntu whose packages are as new.
set -euo pipefail
root=${AUTOGRADER_ROOT:-/autograder}
cd "$root/source/grader"
./course setup --group grade
./course grade @NN@@HIDDEN@
