#!/usr/bin/env bash
# Sets up as quickstart.sh does, builds everything with its tests, and runs them, those in containers too. The last lines
# are ctest's own.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

echo 'check: 1/3 packages'
deploy/setup.sh container

echo 'check: 2/3 build'
quiet=()
[[ -t 1 ]] || quiet=(--quiet)
cmake --preset release --log-level=WARNING -DSKEIN_TESTS=ON >/dev/null
cmake --build build/release -- "${quiet[@]}"

echo 'check: 3/3 tests'
exec ctest --test-dir build/release --label-exclude '^bench$' --no-tests=error --output-on-failure --timeout 600 -j2
