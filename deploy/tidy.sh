#!/usr/bin/env bash
# Runs clang-tidy 14 over our sources, by hand: it takes about as long as a build, so no test waits for it.
#
# usage: deploy/tidy.sh [--all | FILE...]    without arguments: the .cpp files that differ from HEAD~1
# Needs the package clang-tidy-14 and a configured build/release (deploy/check.sh leaves one).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

tool=$(command -v clang-tidy-14 || true)
[[ -n $tool ]] || { echo 'tidy: clang-tidy-14 is not installed; apt-get install clang-tidy-14' >&2; exit 1; }
build=${SKEIN_BUILD:-build/release}
[[ -e $build/compile_commands.json ]] || { echo "tidy: $build is not configured; run deploy/check.sh" >&2; exit 1; }

if [[ ${1:-} == --all ]]; then
  mapfile -t files < <(git ls-files '*.cpp')
elif (($#)); then
  files=("$@")
else
  mapfile -t files < <({ git diff --name-only --diff-filter=d HEAD~1 -- '*.cpp'; git ls-files -o --exclude-standard '*.cpp'; } | sort -u)
fi
((${#files[@]})) || { echo 'tidy: no file to look at'; exit 0; }
echo "tidy: ${#files[@]} files"
printf '%s\0' "${files[@]}" | xargs -0 -n 1 -P "$(nproc)" "$tool" --quiet -p "$build"
