#!/usr/bin/env bash
# Runs clang-tidy 14 over our sources.
#
# usage: deploy/tidy.sh [--full | FILE...]    without arguments: what changed since the commit in deploy/tidy.base
# After a --full without a finding, write `git rev-parse HEAD` into deploy/tidy.base.
# Needs the package clang-tidy-14 and a configured build/release (deploy/check.sh leaves one).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

tool=$(command -v clang-tidy-14 || true)
[[ -n $tool ]] || { echo 'tidy: clang-tidy-14 is not installed; apt-get install clang-tidy-14' >&2; exit 1; }
build=${SKEIN_BUILD:-build/release}
[[ -e $build/compile_commands.json ]] || { echo "tidy: $build is not configured; run deploy/check.sh" >&2; exit 1; }

base=$(<deploy/tidy.base)

# The .cpp files that differ from the base, and for a header that does the one beside it, or one that includes it.
changed() {
  local file
  { git diff --name-only --diff-filter=d "$base" -- '*.cpp' '*.hpp' && git ls-files -o --exclude-standard '*.cpp' '*.hpp'; } |
    while read -r file; do
      if [[ -e ${file%.*}.cpp ]]; then
        echo "${file%.*}.cpp"
      else
        git grep --untracked -l -F "#include \"$file\"" -- '*.cpp' | sed 1q || true
      fi
    done | sort -u
}

if [[ ${1:-} == --full ]]; then
  mapfile -t files < <(git ls-files '*.cpp')
elif (($#)); then
  files=("$@")
elif ! git cat-file -e "$base^{commit}" 2>/dev/null; then
  echo "tidy: NOT RUN: commit $base, with which to compare, is not in this clone; git fetch --unshallow"
  exit 0
else
  listed=$(changed)
  mapfile -t files < <(printf '%s' "$listed")
fi
((${#files[@]})) || { echo 'tidy: no file to look at'; exit 0; }
echo "tidy: ${#files[@]} files"
printf '%s\0' "${files[@]}" | xargs -0 -n 1 -P "$(nproc)" "$tool" --quiet -p "$build"
echo 'tidy: no finding'
