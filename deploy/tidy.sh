#!/usr/bin/env bash
# Runs clang-tidy 14 over our sources.
#
# usage: deploy/tidy.sh [--full | FILE...]    without arguments: what changed since the commit in deploy/tidy.base
# After a run without a finding, write `git rev-parse HEAD` into deploy/tidy.base.
# Needs the package clang-tidy-14 and a configured build/release (deploy/check.sh leaves one).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

tool=$(command -v clang-tidy-14 || true)
[[ -n $tool ]] || { echo 'tidy: clang-tidy-14 is not installed; apt-get install clang-tidy-14' >&2; exit 1; }
build=${SKEIN_BUILD:-build/release}
[[ -e $build/compile_commands.json ]] || { echo "tidy: $build is not configured; run deploy/check.sh" >&2; exit 1; }

base=$(<deploy/tidy.base)
headers=() # whose findings count, as an option; without one, all of ours

# The sources that differ from the base, and those that git does not know yet.
changed() { git diff --name-only --diff-filter=d "$base" -- '*.cpp' '*.hpp' && git ls-files -o --exclude-standard '*.cpp' '*.hpp'; }

# A .cpp file that has this source in it: itself, the one beside it, or one that includes it.
looked_at_with() {
  if [[ -e ${1%.*}.cpp ]]; then
    echo "${1%.*}.cpp"
  else
    git grep --untracked -l -F "#include \"$1\"" -- '*.cpp' | sed 1q || true
  fi
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
  mapfile -t files < <(for file in $listed; do looked_at_with "$file"; done | sort -u |
    while read -r file; do ! grep -qF "$PWD/$file" "$build/compile_commands.json" || echo "$file"; done)
  filter="/($({ grep 'hpp$' <<<"$listed" || true; } | sed 's/[.]/\\./g' | paste -sd '|'))\$"
  headers=("--header-filter=$filter") # what stood before is for --full
fi
((${#files[@]})) || { echo 'tidy: no file to look at'; exit 0; }
echo "tidy: ${#files[@]} files"
printf '%s\0' "${files[@]}" | xargs -0 -n 1 -P "$(nproc)" "$tool" --quiet "${headers[@]}" -p "$build"
echo 'tidy: no finding'
