#!/usr/bin/env bash
# The same set-up as run.sh, then every test.
#
# usage: tools/test.sh [OPTIONS OF ctest]           e.g. tools/test.sh -L slow, tools/test.sh -R Rk4
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# all_verify_interface_header_sets: every public header compiles alone. It is no part of `all`.
tools/build.sh release all all_verify_interface_header_sets
echo "== test: preset release"
ctest --preset release -j 2 "$@"
