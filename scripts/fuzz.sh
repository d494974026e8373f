#!/usr/bin/env bash
# Runs libFuzzer on the readers of what comes from outside; `make fuzz SECONDS=300` builds and calls it.
#   scripts/fuzz.sh [--keep] [SECONDS] [TARGET]...     seconds of each target [20]; targets [all]
#   --keep     leaves the fewest inputs that reach all that was reached in tests/data/fuzz/TARGET.inputs, which every test
#              run plays again; SECONDS=0 does that alone
# It starts from those and goes on from build/fuzz/TARGET/, what it found before. An input that breaks a reader is kept in
# build/fuzz/findings/, and the status is 1. Says at the start how long it takes, 18 minutes for all 48 targets; the table
# is build/fuzz/table.txt too.
# Example: scripts/fuzz.sh 300 matchFile robotFile
set -uo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
program=build/Fuzz/bin/fuzz
fail() { echo "fuzz.sh: $*" >&2; exit 2; }
[[ -x $program ]] || fail "no $program: make fuzz builds it"
keep=""
if [[ ${1-} == --keep ]]; then keep=yes; shift; fi
seconds=${1:-20}
shift || true
[[ $seconds =~ ^[0-9]+$ ]] && [[ $seconds -gt 0 || $keep ]] || fail "'$seconds' is no number of seconds"
mapfile -t all < <("$program")
targets=("$@")
((${#targets[@]})) || targets=("${all[@]}")
steady=()
setarch -R true 2> /dev/null && steady=(setarch -R) # sanitizers fail on some kernels that place memory very randomly
mkdir -p build/fuzz/findings
for target in "${targets[@]}"; do
  [[ " ${all[*]} " == *" $target "* ]] || fail "no target $target; there is ${all[*]}"
done

# The fewest inputs that reach all, in one file: of each its length, its bytes. Long ones stay here, and so does what is
# beyond $most bytes or $many inputs: every test run pays for them.
most=32768 many=60
pack() { # target
  local merged=build/fuzz/merged to=tests/data/fuzz/$1.inputs file size all=0 number=0
  rm -rf "$merged"
  mkdir -p "$merged" "${to%/*}"
  PLUMBLINE_FUZZ_TARGET=$1 "${steady[@]}" "$program" -set_cover_merge=1 -max_len=4000 -timeout=20 -rss_limit_mb=2048 \
    "$merged" "build/fuzz/$1" > "build/fuzz/$1.merge.log" 2>&1 || { echo "fuzz.sh: $1 was not merged: build/fuzz/$1.merge.log" >&2; return 1; }
  for file in $(find "$merged" -type f -size -4001c -printf '%s %p\n' | LC_ALL=C sort -n | cut -d' ' -f2); do
    size=$(stat -c %s "$file")
    ((all + size <= most && number < many)) || break
    all=$((all + size)) number=$((number + 1))
    echo "$size" && cat "$file" && echo
  done > "$to.new"
  if ((number == 0)); then # nothing that is short
    rm -f "$to.new"
    echo "nothing to keep of $1: no input of at most 4000 bytes"
    return
  fi
  mv "$to.new" "$to"
  echo "kept: $to, $number inputs of $(find "$merged" -type f | wc -l)"
}
keepAll() {
  local target bad=0
  for target in "${targets[@]}"; do pack "$target" || bad=1; done
  rm -rf build/fuzz/merged
  return $bad
}
if ((seconds == 0)); then keepAll; exit; fi

total=0 bad=0 number=0
echo "fuzz: ${#targets[@]} targets, $seconds s each: done about $(date -d "+$((${#targets[@]} * (seconds + 3))) seconds" +%H:%M)"
printf '%-16s %12s %10s %8s  %s\n' target executions branches seconds result | tee build/fuzz/table.txt
for target in "${targets[@]}"; do
  number=$((number + 1))
  [[ -t 1 ]] && printf '%d of %d %s\r' $number ${#targets[@]} "$target" >&2
  corpus=build/fuzz/$target log=build/fuzz/$target.log
  mkdir -p "$corpus"
  PLUMBLINE_FUZZ_TARGET=$target PLUMBLINE_FUZZ_SEEDS=$corpus "${steady[@]}" "$program" || fail "no seeds of $target"
  export PLUMBLINE_FUZZ_TARGET=$target
  status=0
  ASAN_OPTIONS=${ASAN_OPTIONS:-} UBSAN_OPTIONS=${UBSAN_OPTIONS:-print_stacktrace=1} "${steady[@]}" "$program" "$corpus" \
    -max_total_time="$seconds" -max_len=20000 -rss_limit_mb=2048 -malloc_limit_mb=512 -timeout=20 -print_final_stats=1 \
    -artifact_prefix="build/fuzz/findings/$target-" > "$log" 2>&1 || status=$?
  inputs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  covered=$(grep -o 'cov: [0-9]*' "$log" | tail -1 | tr -dc 0-9)
  total=$((total + ${inputs:-0}))
  if ((status)); then
    bad=$((bad + 1))
    printf '%-16s %12s %10s %8s  FOUND: %s\n' "$target" "${inputs:-?}" "${covered:-?}" "$seconds" \
      "$(grep -m 1 -E 'ERROR|SUMMARY|what\(\)|runtime error' "$log")" | tee -a build/fuzz/table.txt
    echo "    $(grep -o 'build/fuzz/findings/[^ ]*' "$log" | tail -1); log: $log"
  else
    printf '%-16s %12s %10s %8s  nothing found\n' "$target" "$inputs" "$covered" "$seconds" | tee -a build/fuzz/table.txt
  fi
done
echo "$total executions, $bad of ${#targets[@]} targets broke" | tee -a build/fuzz/table.txt
if [[ $keep ]]; then keepAll || bad=1; fi
((bad == 0))
