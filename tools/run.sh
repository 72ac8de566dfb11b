#!/usr/bin/env bash
# Installs what is missing, builds, and runs the paper's vehicle through every form and method against each other.
#
# usage: tools/run.sh [OPTIONS OF vehicle validate]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

tools/build.sh release vehicle_cli
echo "== run: the paper's vehicle at 20 m/s, form against form and method against method"
OPENBLAS_NUM_THREADS=1 build/release/bin/vehicle validate \
  models/vehicles/al-oraiqat-2017.xml models/scenarios/paper-20mps.xml "$@"
