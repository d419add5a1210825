#!/usr/bin/env bash
# Sets up as quickstart.sh does, builds everything with its tests, and runs them, those in containers last; beside them,
# at the lowest priority, clang-tidy on what changed, sanitizers and fuzzing. The last lines say what held.
#
# usage: deploy/check.sh [--no-containers]   without the tests in containers: for where there is no engine or no root
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

purpose=container
if [[ ${1:-} == --no-containers ]]; then
  purpose=check
elif [[ $# -gt 0 ]]; then
  echo "check: unknown argument '$1'; allowed: --no-containers" >&2
  exit 2
fi

echo 'check: 1/4 packages'
deploy/setup.sh "$purpose"

echo 'check: 2/4 build'
quiet=()
[[ -t 1 ]] || quiet=(--quiet)
cmake --preset release --log-level=WARNING -DSKEIN_TESTS=ON >/dev/null
cmake --build build/release -- "${quiet[@]}"
# Each part is a process group of its own, so that none of it outlives this script.
set -m
groups=()
end_groups() {
  local group
  for group in "${groups[@]}"; do kill -- "-$group" 2>/dev/null || true; done
  wait
}
trap end_groups EXIT
trap 'exit 130' INT
trap 'exit 143' TERM
start() {
  "$@" </dev/null &
  groups+=($!)
}
run_tests() { start ctest --test-dir build/release --no-tests=error --output-on-failure "$@"; }

echo 'check: 3/4 tests; beside them clang-tidy and the build for the sanitizers'
start nice -n 19 bash -c 'deploy/tidy.sh && deploy/sanitize.sh --build' >build/static.log 2>&1
static=$!
held=0
run_tests --label-exclude '^(bench|container)$' --timeout 600 -j2
wait "$!" || held=$?

echo 'check: 4/4 sanitizers and fuzzing; beside them containers'
if wait "$static"; then
  start nice -n 19 deploy/sanitize.sh >>build/static.log 2>&1
  static=$!
else
  held=1
fi
if [[ $purpose == container ]]; then
  run_tests -V -L '^container$'
  wait "$!" || held=$?
fi
wait "$static" || { held=$?; tail -n 100 build/static.log >&2; }
grep -E '^(tidy|sanitize): ' build/static.log || true
((held == 0)) && echo 'check: all of it held' || echo 'check: something did not hold; see above'
exit "$held"
