#!/usr/bin/env bash
# Plays scripts of tests/ with programs that are built with the address and undefined-behaviour sanitizers; the first
# finding ends a program, and the script fails.
#   scripts/sanitized_programs.sh [SCRIPT]...     [those that start every program and read every kind of file]
# Example: scripts/sanitized_programs.sh tests/e2e/bad_input.sh
set -uo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
scripts=("$@")
((${#scripts[@]})) || scripts=(tests/e2e/bad_input.sh tests/e2e/log.sh tests/e2e/optserver.sh tests/e2e/rdb.sh tests/e2e/match.sh)
for script in "${scripts[@]}"; do
  [[ -f $script ]] || { echo "sanitized_programs.sh: no $script" >&2; exit 2; }
done
scripts/build.sh SimSanitize || exit 2
steady=()
setarch -R true 2> /dev/null && steady=(setarch -R) # sanitizers fail on some kernels that place memory very randomly
mkdir -p build/SimSanitize/logs
bad=0
for script in "${scripts[@]}"; do
  log=build/SimSanitize/logs/${script//\//-}.log
  start=$SECONDS
  if PLUMBLINE_BIN=$PWD/build/SimSanitize/bin UBSAN_OPTIONS=print_stacktrace=1 ASAN_OPTIONS=detect_leaks=0 \
    "${steady[@]}" bash "$script" > "$log" 2>&1; then
    echo "ok    $script, $((SECONDS - start)) s"
  else
    bad=$((bad + 1))
    echo "FAIL  $script, $((SECONDS - start)) s; log: $log"
    grep -nE 'ERROR: AddressSanitizer|runtime error|FAILED' "$log" | head -5
  fi
done
echo "$((${#scripts[@]} - bad)) passed, $bad failed"
((bad == 0))
