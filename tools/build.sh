#!/usr/bin/env bash
# The set-up that run.sh, test.sh and CI share: installs what is missing, configures a preset, builds targets.
#
# usage: tools/build.sh [PRESET [TARGET...]]        (default: release, everything)
# VEHICLE_CONFIGURE holds more options of the configuration, e.g. "-D CMAKE_UNITY_BUILD=ON".
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

preset=${1:-release}
targets=("${@:2}")
((${#targets[@]})) || targets=(all)

tools/install-dependencies.sh
echo "== configure: preset $preset in build/$preset"
read -ra options <<<"${VEHICLE_CONFIGURE:-}"
cmake --preset "$preset" --log-level=WARNING "${options[@]}"
# Two jobs, set by the preset: a file that includes Simbody or much Eigen takes more than a gigabyte to compile.
echo "== build: ${targets[*]}"
cmake --build --preset "$preset" --target "${targets[@]}"
