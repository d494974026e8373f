#!/usr/bin/env bash
# Runs libFuzzer on the readers of what comes from outside; `make fuzz SECONDS=300` builds and calls it.
#   scripts/fuzz.sh [SECONDS] [TARGET]...     seconds of each target [60]; targets [all]
# What was found before goes on from build/fuzz/TARGET/; an input that breaks a reader is kept in
# build/fuzz/findings/, and the status is 1. Says at the start how long it takes; the table is build/fuzz/table.txt too.
# Example: scripts/fuzz.sh 300 matchFile robotFile
set -uo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
program=build/Fuzz/bin/fuzz
fail() { echo "fuzz.sh: $*" >&2; exit 2; }
[[ -x $program ]] || fail "no $program: make fuzz builds it"
seconds=${1:-60}
shift || true
[[ $seconds =~ ^[0-9]+$ ]] && ((seconds > 0)) || fail "'$seconds' is no number of seconds"
mapfile -t all < <("$program")
targets=("$@")
((${#targets[@]})) || targets=("${all[@]}")
steady=()
setarch -R true 2> /dev/null && steady=(setarch -R) # sanitizers fail on some kernels that place memory very randomly
mkdir -p build/fuzz/findings
total=0 bad=0 number=0
echo "fuzz: ${#targets[@]} targets, $seconds s each: done about $(date -d "+$((${#targets[@]} * (seconds + 3))) seconds" +%H:%M)"
printf '%-16s %12s %10s %8s  %s\n' target executions branches seconds result | tee build/fuzz/table.txt
for target in "${targets[@]}"; do
  number=$((number + 1))
  [[ -t 1 ]] && printf '%d of %d %s\r' $number ${#targets[@]} "$target" >&2
  [[ " ${all[*]} " == *" $target "* ]] || fail "no target $target; there is ${all[*]}"
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
((bad == 0))
