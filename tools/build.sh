#!/usr/bin/env bash
# The set-up that run.sh, test.sh and CI share: installs what is missing, configures a preset, builds targets.
#
# usage: tools/build.sh [PRESET [TARGET...]]        (default: release, everything)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

preset=${1:-release}
targets=("${@:2}")
((${#targets[@]})) || targets=(all)

tools/install-dependencies.sh
echo "== configure: preset $preset in build/$preset"
cmake --preset "$preset" --log-level=WARNING
# Two jobs, set by the preset: a file that includes Simbody or much Eigen takes more than a gigabyte to compile.
echo "== build: ${targets[*]}"
cmake --build --preset "$preset" --target "${targets[@]}"
