#!/usr/bin/env bash
# Sets up as quickstart.sh does, builds everything with its tests, and runs them. The last lines are ctest's own.
#
# usage: deploy/check.sh [--containers]   the tests in containers too: they need an engine, and up to half an hour more
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

purpose=check
left_out='^(bench|container)$'
if [[ ${1:-} == --containers ]]; then
  purpose=container
  left_out='^bench$'
elif [[ $# -gt 0 ]]; then
  echo "check: unknown argument '$1'; allowed: --containers" >&2
  exit 2
fi

echo 'check: 1/3 packages'
deploy/setup.sh "$purpose"

echo 'check: 2/3 build'
quiet=()
[[ -t 1 ]] || quiet=(--quiet)
cmake --preset release --log-level=WARNING -DSKEIN_TESTS=ON >/dev/null
cmake --build build/release -- "${quiet[@]}"

echo 'check: 3/3 tests'
exec ctest --test-dir build/release --label-exclude "$left_out" --no-tests=error --output-on-failure --timeout 600 -j2
