#!/usr/bin/env bash
# Installs the Debian 12 packages that vehicle is built and tested with: the one list of dependencies.
# Where all of them are present it does nothing, without network and without rights.
#
# usage: tools/install-dependencies.sh [--benchmark-peers]
#   --benchmark-peers   also the solvers that benchmarks/ compares with; no build and no test needs them
set -euo pipefail

packages=(
  g++ cmake ninja-build                                  # to build
  clang clang-tidy libclang-rt-14-dev                    # the second compiler, its checks, its sanitizers
  libboost-dev libpagmo-dev                              # Sobol's direction numbers, odeint as a peer; search
  libeigen3-dev libsimbody-dev liblapack-dev             # numbers and bodies; Simbody's CMake targets name lapack and blas
  libhwloc-dev                                           # where cores and caches are
  libopenmpi-dev openmpi-bin                             # studies on many machines; optional at build
  libtinyxml2-dev libhdf5-dev libsqlite3-dev             # files
  libfmt-dev libcli11-dev nlohmann-json3-dev             # messages, command line
  libgtest-dev libbenchmark-dev                          # tests and benchmarks
  libxml2-utils octave                                   # xmllint judges the models; Octave is the paper's ode45
)
peers=(libsundials-dev)                                  # Octave, the third peer, is above

case "${1:-}" in
  "") ;;
  --benchmark-peers) packages+=("${peers[@]}") ;;
  *) echo "install-dependencies.sh: unknown option '$1'; did you mean --benchmark-peers?" >&2; exit 2 ;;
esac

missing=()
for package in "${packages[@]}"; do
  # shellcheck disable=SC2016  # ${...} is dpkg's, not the shell's
  status=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null || true)
  [[ $status == installed ]] || missing+=("$package")
done
if ((${#missing[@]} == 0)); then
  echo "== dependencies: all ${#packages[@]} packages are installed"
  exit 0
fi

as_root=()
if ((EUID != 0)); then
  if ! command -v sudo >/dev/null; then
    echo "install-dependencies.sh: missing packages: ${missing[*]}" >&2
    echo "  neither root nor sudo here; let an administrator run: apt-get install ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

# Another apt (unattended upgrades on a fresh machine) may hold a lock for minutes: ask again before giving up.
apt() {
  local attempt
  for attempt in 1 2 3 4 5 6; do
    if "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -o DPkg::Lock::Timeout=120 "$@"; then return 0; fi
    if ((attempt < 6)); then
      echo "== apt-get $1 failed (attempt $attempt of 6); again in 10 s" >&2
      sleep 10
    fi
  done
  echo "install-dependencies.sh: apt-get $* failed six times; its message stands above" >&2
  return 1
}

echo "== dependencies: installing ${missing[*]}"
apt update
apt install -y --no-install-recommends "${missing[@]}"
