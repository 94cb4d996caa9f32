#!/usr/bin/env bash
# build.sh <preset> [target...]: installs what is missing, configures and builds.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
preset="$1"
shift
# nproc would count the threads of OpenMP instead of processors.
unset OMP_NUM_THREADS OMP_THREAD_LIMIT
cmake/install-packages.sh

# A source that includes Trilinos or CGAL takes up to 2 GB to compile.
memory_gb="$(awk '/^MemAvailable:/ {print int($2 / 1048576)}' /proc/meminfo)"
jobs="$((memory_gb / 2))"
((jobs <= $(nproc))) || jobs="$(nproc)"
((jobs >= 1)) || jobs=1

cmake --preset "$preset"
cmake --build --preset "$preset" --parallel "$jobs" ${1:+--target "$@"}
