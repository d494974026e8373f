#!/usr/bin/env bash
# Runs tests and says what failed.
#   scripts/run_tests.sh --all              builds SimRelease and SimSanitize and runs everything
#   scripts/run_tests.sh TARGET AREA...     runs test programs that are built, and tests/AREA/*.sh with SimRelease
# Logs go to build/<target>/logs/. The last line is "N passed, N failed".
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
root=$PWD
jobs=${JOBS:-$(nproc)}
timeout=${TEST_TIMEOUT:-600} # seconds for one program or script
passed=0 failed=0
failures=()
export UBSAN_OPTIONS=${UBSAN_OPTIONS:-print_stacktrace=1}

# Adds one result: name, log, exit status, tests passed, tests failed, seconds.
account() {
  local name=$1 log=$2 status=$3 good=$4 bad=$5 seconds=$6
  if ((status != 0 && bad == 0)); then bad=1; fi
  passed=$((passed + good)) failed=$((failed + bad))
  if ((bad)); then
    printf '  FAIL  %-38s %4d passed, %d failed  %5.1f s  log: %s\n' "$name" "$good" "$bad" "$seconds" "${log#"$root"/}"
    failures+=("$log")
  else
    printf '  ok    %-38s %4d passed            %5.1f s\n' "$name" "$good" "$seconds"
  fi
}

# Runs one test program or script in the background slot; leaves its result beside the log.
runOne() { # $1 target, $2 kind, $3 path, $4 name
  local log=build/$1/logs/${4//\//-}.log status start end
  local -x PLUMBLINE_TARGET=$1 PLUMBLINE_BIN=$root/build/$1/bin # for tests that start programs
  [[ $1 == SimRelease ]] && PLUMBLINE_BIN=$root/bin
  start=$(date +%s%N)
  rm -f "$log" "$log.xml" "$log.result"
  if [[ $2 == program ]]; then
    timeout -k 10 "$timeout" "$3" --gtest_brief=1 --gtest_color=no "--gtest_output=xml:$log.xml" > "$log" 2>&1 < /dev/null
  else
    timeout -k 10 "$timeout" bash "$3" > "$log" 2>&1 < /dev/null
  fi
  status=$?
  end=$(date +%s%N)
  local good=0 bad=0
  if [[ $2 == program && -s $log.xml ]]; then
    read -r good bad < <(sed -n '/<testsuites /{s/.*tests="\([0-9]*\)" failures="\([0-9]*\)" disabled="\([0-9]*\)" errors="\([0-9]*\)".*/\1 \2 \3 \4/p;q}' "$log.xml" |
      awk '{ print $1 - $2 - $3 - $4, $2 + $4 }')
  elif ((status == 0)); then good=1
  else bad=1
  fi
  ((status == 124 || status == 137)) && echo "run_tests.sh: stopped after $timeout s" >> "$log"
  echo "$status ${good:-0} ${bad:-1} $(awk "BEGIN{print ($end - $start) / 1e9}")" > "$log.result"
}

# Runs the tests of one target: test programs, then shell tests (SimRelease only), as many at once as jobs.
runTarget() { # $1 target, $2... areas
  local target=$1 area path names=() kinds=() paths=() i
  shift
  mkdir -p "build/$target/logs"
  for area in "$@"; do
    path=build/$target/tests/$area
    [[ -x $path && -f $path ]] && names+=("$area") kinds+=(program) paths+=("$path")
    if [[ $target == SimRelease && -d tests/$area ]]; then
      while read -r path; do
        names+=("${path#tests/}") kinds+=(script) paths+=("$path")
      done < <(find "tests/$area" -name '*.sh' -perm -u+x | LC_ALL=C sort)
    fi
  done
  local running=0
  for ((i = 0; i < ${#names[@]}; ++i)); do
    if ((running >= jobs)); then wait -n; running=$((running - 1)); fi
    runOne "$target" "${kinds[i]}" "${paths[i]}" "${names[i]}" &
    running=$((running + 1))
  done
  wait
  for ((i = 0; i < ${#names[@]}; ++i)); do
    local log=build/$target/logs/${names[i]//\//-}.log status=1 good=0 bad=1 seconds=0
    [[ -f $log.result ]] && read -r status good bad seconds < "$log.result"
    account "$target ${names[i]}" "$log" "$status" "$good" "$bad" "$seconds"
  done
}

# Runs one command as a test of its own; its output is the log.
runStep() { # $1 name, then the command
  local name=$1 log=build/logs/${1// /-}.log start=$SECONDS
  shift
  mkdir -p build/logs
  if "$@" > >(tee "$log") 2>&1; then account "$name" "$log" 0 1 0 $((SECONDS - start)); else account "$name" "$log" 1 0 1 $((SECONDS - start)); return 1; fi
}

areasOf() { find tests -mindepth 1 -maxdepth 1 -type d ! -name bench ! -name support -printf '%f\n' | LC_ALL=C sort; }

if [[ ${1-} == --all ]]; then
  runStep "floors" scripts/check_floors.sh
  runStep "sizes" scripts/check_sizes.sh
  mapfile -t areas < <(areasOf)
  runStep "build SimRelease" make SimRelease SimRelease-tests && runTarget SimRelease "${areas[@]}"
  runStep "build SimSanitize" make SimSanitize-tests && runTarget SimSanitize "${areas[@]}"
else
  target=$1
  shift
  runTarget "$target" "$@"
fi

for log in "${failures[@]}"; do
  echo
  echo "---- $log"
  grep -nE 'Failure|FAILED|ERROR|error|stopped after|\.sh:|runtime error' "$log" | head -20
  tail -5 "$log"
done
echo
echo "$passed passed, $failed failed"
((failed == 0 && passed > 0))
