#!/usr/bin/env bash
# From a fresh Debian 12 to the main job: installs what is missing, builds, and runs a formation rendezvous of three
# UAVs, each its own process. Ends with the run's exit code. A second call installs and builds nothing.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

echo 'quickstart: 1/3 packages'
deploy/setup.sh build

echo 'quickstart: 2/3 build'
quiet=()
[[ -t 1 ]] || quiet=(--quiet)
without_tests=()
[[ -e build/release/CMakeCache.txt ]] || without_tests=(-DSKEIN_TESTS=OFF) # a folder of check.sh keeps its tests
cmake --preset release --log-level=WARNING "${without_tests[@]}" >/dev/null
cmake --build build/release --target skein skein-agent skein-simworld -- "${quiet[@]}"

echo 'quickstart: 3/3 run'
exec build/release/bin/skein run deploy/scenarios/rendezvous-2d.yaml --seed 1
