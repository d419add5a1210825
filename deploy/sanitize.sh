#!/usr/bin/env bash
# Runs the swarm and the readers of foreign bytes under the address and undefined-behaviour sanitizers (preset 'dev').
#
# usage: deploy/sanitize.sh [--full | --build]
#   --full    every unit and property test too, and a longer fuzzing: an hour or two
#   --build   only builds what it runs
# Needs what `deploy/setup.sh check` installs, and build/release/bin/skein, of which it takes the state hashes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

inputs=20000 # mutated inputs for each fuzz target
targets=(wire_fuzz scenario_fuzz round_record_fuzz)
binaries=(skein-agent skein-simworld)
case ${1:-} in
  '' | --build) ;;
  --full) inputs=2000000 binaries=(all) ;;
  *) echo "sanitize: unknown argument '$1'; allowed: --full, --build" >&2 && exit 2 ;;
esac
build=build/dev
work=$(mktemp -d)
clean_up() {
  local left
  left=$(jobs -p)
  [[ -z $left ]] || kill $left 2>/dev/null || true
  wait
  rm -rf "$work"
}
trap clean_up EXIT
export ASAN_OPTIONS=abort_on_error=1 UBSAN_OPTIONS=halt_on_error=1:print_stacktrace=1

# Exit code 0 if no input of the corpus, nor `inputs` mutated ones, breaks what the target demands.
fuzz() {
  local target=$1
  if ! "$build/fuzz/$target" -runs="$inputs" -seed=1 -max_len=16384 -timeout=60 -artifact_prefix="$build/fuzz/" \
    "$work/$target" >"$work/$target.log" 2>&1; then
    tail -n 60 "$work/$target.log" >&2
    echo "sanitize: $target failed; the input is in $build/fuzz" >&2
    return 1
  fi
  echo "sanitize: $target: $(grep -c . < <(ls "$work/$target")) inputs in the corpus, $(tail -n 1 "$work/$target.log")"
}

hash_of() { python3 -c 'import json, sys; print(json.load(open(sys.argv[1]))["state_hash"])' "$1"; }

# A swarm of sanitized processes, started by hand: every one ends with 0, and the state hash is that of build/release.
fly() {
  local scenario=deploy/scenarios/$1.yaml agents=$2 out=$work/$1 pids=() id pid plain sanitized
  local bus=(--domain 99 --swarm "sanitize-$$-$1" --startup-timeout 120)
  if ! build/release/bin/skein run "$scenario" --seed 1 --in-process --out "$out/plain" >"$work/$1.log" 2>&1; then
    cat "$work/$1.log" >&2
    return 1
  fi
  "$build/bin/skein-simworld" "$scenario" --seed 1 "${bus[@]}" --set lockstep.deadline_s=120 --out "$out/sanitized" \
    --checkpoint "$out/checkpoint" >"$work/$1.world.log" 2>&1 &
  pids+=($!)
  for ((id = 1; id <= agents; ++id)); do
    "$build/bin/skein-agent" --id "$id" "${bus[@]}" >"$work/$1.agent$id.log" 2>&1 &
    pids+=($!)
  done
  for pid in "${pids[@]}"; do
    if ! wait "$pid"; then
      kill "${pids[@]}" 2>/dev/null || true
      tail -n 40 "$work/$1".*.log >&2
      echo "sanitize: a process of $1 failed" >&2
      return 1
    fi
  done
  plain=$(hash_of "$out/plain/report.json")
  sanitized=$(hash_of "$out/sanitized/report.json")
  if [[ $plain != "$sanitized" ]]; then
    echo "sanitize: $1: the state hash of clang's build is $sanitized, that of build/release $plain" >&2
    return 1
  fi
  echo "sanitize: $1: $((agents + 1)) processes, state hash $sanitized as built by g++"
}

echo 'sanitize: 1/3 build'
cmake --preset dev --log-level=WARNING -DSKEIN_TESTS=ON >/dev/null
cmake --build "$build" --target "${targets[@]}" "${binaries[@]}" idl_dds_renewal_test -- --quiet
[[ ${1:-} != --build ]] || exit 0
echo 'sanitize: 2/3 swarms'
fly rendezvous-2d 3
fly transit-partition 6
fly rendezvous-surprise 3
"$build/tests/idl_dds_renewal_test" >"$work/renewal.log" 2>&1 || { tail -n 100 "$work/renewal.log" >&2 && exit 1; }
echo "sanitize: idl_dds_renewal_test: $(tail -n 1 "$work/renewal.log")"
echo 'sanitize: 3/3 fuzzing'
python3 -B tests/fuzz/seeds.py "$work" "$work"/rendezvous-2d/checkpoint/*
for target in "${targets[@]}"; do fuzz "$target"; done
[[ ${1:-} != --full ]] || ctest --test-dir "$build" -L '^(unit|property)$' --no-tests=error --output-on-failure -j2
