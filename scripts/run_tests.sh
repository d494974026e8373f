#!/usr/bin/env bash
# Runs tests and says what failed.
#   scripts/run_tests.sh --all              runs everything: scripts and what computes for long with SimRelease, the
#                                           other test programs and some of the scripts with SimSanitize
#   scripts/run_tests.sh [TARGET] AREA...   builds and runs the tests of tests/AREA with SimRelease or TARGET
# Logs go to build/<target>/logs/. The last line is "N passed, N failed[; N of ...]". With --all up to three tests that failed while
# others ran are repeated alone, and the second run counts: a busy machine must not spoil the results of the other
# tests. A list before the last line and the last line itself say so, and what failed first stays in LOG.first;
# SECOND_RUN=no turns it off. Examples:
#   scripts/run_tests.sh framework robot
#   scripts/run_tests.sh SimSanitize web
set -uo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
root=$PWD
# One more than are built at once: many scripts wait for a clock or a browser most of their time.
jobs=${TEST_JOBS:-$((${JOBS:-$(nproc)} + 1))}
cpuSeconds=${TEST_CPU_SECONDS:-600} # of one program or script: what it computes, however busy the machine is
timeout=${TEST_TIMEOUT:-3600} # seconds until one that waits for ever is stopped
testsPerPart=100 longPerPart=40
longAreas=(diagnosis fidelity gap training) # compute for long, under the sanitizers five times as long: there in make check alone
# Scripts that sanitized programs play, too: those that start most programs, with wrong input and with several at once.
sanitizedScripts=(e2e/bad_input.sh e2e/optserver.sh)
sanitizedPrograms=(agent game gap optimizewalk optserver optworker simplemonitor simulator watchgame webmonitor)
passed=0 failed=0 programAreas=() # empty: all
scriptsOfTarget() { [[ $1 == SimRelease ]]; } # $1 target, $2 script: whether it is played with that target's programs
failures=() twice=() unsteady=0
secondRuns=0 # of each target: how many tests that failed run again alone
progress=""
export UBSAN_OPTIONS=${UBSAN_OPTIONS:-print_stacktrace=1}
export TSAN_OPTIONS=${TSAN_OPTIONS:-suppressions=$root/tests/support/thread.supp second_deadlock_stack=1}

# Adds one result and prints it: name, log, exit status, tests passed, failed, seconds, tests skipped, seconds of computing.
account() {
  local name=$1 log=$2 status=$3 good=$4 bad=$5 seconds=$6 skipped=${7:-0} computed=${8:-0}
  if ((status != 0 && bad == 0)); then bad=1; fi
  passed=$((passed + good)) failed=$((failed + bad))
  if ((bad)); then
    printf '%s FAIL  %-38s %4d passed, %d failed %6.1f s  log: %s\n' "$progress" "$name" "$good" "$bad" "$seconds" "$log"
    failures+=("$log")
  else
    printf '%s ok    %-38s %4d passed%s           %6.1f s, %6.1f s of computing\n' "$progress" "$name" "$good" \
      "$( ((skipped)) && echo ", $skipped skipped")" "$seconds" "$computed"
  fi
}

# Sanitizers of this compiler fail on some kernels that place memory very randomly: then, without.
steady=()
setarch -R true 2> /dev/null && steady=(setarch -R)

scratch=$(mktemp -d) # of the test programs; goes with Ctrl-C too
trap 'rm -rf "$scratch"' EXIT

logOf() { echo "build/$1/logs/${2//[\/ ]/-}.log"; } # $1 target, $2 name

# Into how many parts a test program goes, so that the longest do not keep one core busy at the end. One that
# can't tell its tests is run as a whole, and fails there.
partsOf() { # $1 program, $2 area
  local tests most=$testsPerPart
  [[ " ${longAreas[*]} " == *" $2 "* ]] && most=$longPerPart
  tests=$("${steady[@]}" timeout 60 "$1" --gtest_list_tests 2> /dev/null < /dev/null | grep -c '^  ')
  echo $(((tests > 0 ? tests + most - 1 : most) / most))
}

# Runs one test program or script in the background slot; leaves its result beside the log.
runOne() { # $1 target, $2 kind, $3 path, $4 name, $5 $6 which part of how many
  local log status start end
  log=$(logOf "$1" "$4")
  local -x PLUMBLINE_TARGET=$1 PLUMBLINE_BIN=$root/build/$1/bin # for tests that start programs
  [[ $1 == SimRelease ]] && PLUMBLINE_BIN=$root/bin
  start=$(date +%s%N)
  rm -f "$log" "$log.xml" "$log.result"
  ulimit -S -t "$cpuSeconds" # runOne has a shell of its own
  if [[ $2 == program ]]; then
    [[ $1 == *Sanitize* || $1 == *Thread* ]] || steady=()
    local -x GTEST_SHARD_INDEX=$5 GTEST_TOTAL_SHARDS=$6 TMPDIR # parts run beside each other: no files in common
    TMPDIR=$(mktemp -d -p "$scratch")
    timeout -k 10 "$timeout" "${steady[@]}" "$3" --gtest_brief=1 --gtest_color=no "--gtest_output=xml:$log.xml" > "$log" 2>&1 < /dev/null
  else
    [[ $1 == *Sanitize* ]] && local -x ASAN_OPTIONS=${ASAN_OPTIONS:-detect_leaks=0} || steady=()
    timeout -k 10 "$timeout" "${steady[@]}" bash "$3" > "$log" 2>&1 < /dev/null
  fi
  status=$?
  end=$(date +%s%N)
  local good=0 bad=0 skipped=0
  if [[ $2 == program && -s $log.xml ]]; then
    read -r good bad skipped < <(awk '
      function number(key) { return match($0, " " key "=\"[0-9]+") ? substr($0, RSTART + length(key) + 3, RLENGTH - length(key) - 3) : 0 }
      /<testsuite / { bad += number("failures") + number("errors"); skipped += number("skipped"); all += number("tests") - number("disabled") }
      END { print all - bad - skipped, bad + 0, skipped + 0 }' "$log.xml")
  elif ((status == 0)); then good=1
  else bad=1
  fi
  ((status == 124 || status == 137)) && echo "run_tests.sh: stopped after $timeout s" >> "$log"
  # 152: the signal of the limit; a script that it meets in a child fails by itself.
  ((status == 152)) && echo "run_tests.sh: stopped after $cpuSeconds s of computing" >> "$log"
  times > "$log.times" # in its second line, user and system time of what this shell has started
  echo "$status ${good:-0} ${bad:-1} $(awk "BEGIN{print ($end - $start) / 1e9}") $skipped $(awk -F '[ms ]+' '
    NR == 2 {print 60 * $1 + $2 + 60 * $3 + $4}' "$log.times")" > "$log.result"
  rm -f "$log.times"
}

# Runs the tests of one target: test programs, then shell tests that it plays, as many at once as jobs.
runTarget() { # $1 target, $2... areas
  local target=$1 area path names=() kinds=() paths=() part=() parts=() i p n log
  shift
  mkdir -p "build/$target/logs"
  for area in "$@"; do
    path=build/$target/tests/$area
    if [[ (${#programAreas[@]} == 0 || " ${programAreas[*]} " == *" $area "*) && -x $path && -f $path ]]; then
      n=$(partsOf "$path" "$area")
      for ((p = 0; p < n; ++p)); do
        names+=("$area$( ((n > 1)) && echo " $((p + 1)) of $n")") kinds+=(program) paths+=("$path") part+=($p) parts+=($n)
      done
    fi
    if [[ -d tests/$area ]]; then
      while read -r path; do
        scriptsOfTarget "$target" "${path#tests/}" || continue
        names+=("${path#tests/}") kinds+=(script) paths+=("$path") part+=(0) parts+=(1)
      done < <(find "tests/$area" -name '*.sh' | LC_ALL=C sort)
    fi
  done
  local -A indexOf=()
  local total=${#names[@]} pid finished=0 started=0 again=()
  while ((finished < ${#names[@]})); do
    if ((started < ${#names[@]} && started - finished < jobs)); then
      runOne "$target" "${kinds[started]}" "${paths[started]}" "${names[started]}" "${part[started]}" "${parts[started]}" &
      indexOf[$!]=$started
      started=$((started + 1))
      continue
    fi
    wait -n -p pid
    i=${indexOf[$pid]}
    finished=$((finished + 1))
    progress=$(printf '[%*d/%d]' ${#total} "$finished" "${#names[@]}")
    if ((${#again[@]} < secondRuns)) && ! isGood "$target" "${names[i]}"; then
      echo "$progress again $target ${names[i]}: failed, runs once more alone at the end"
      again+=("$i")
    else
      accountFor "$target" "${names[i]}"
    fi
  done
  progress=""
  for i in "${again[@]}"; do
    log=$(logOf "$target" "${names[i]}")
    cp "$log" "$log.first"
    (runOne "$target" "${kinds[i]}" "${paths[i]}" "${names[i]}" "${part[i]}" "${parts[i]}")
    if isGood "$target" "${names[i]}"; then
      twice+=("passed  $target ${names[i]}: $log.first") unsteady=$((unsteady + 1))
    else
      twice+=("failed  $target ${names[i]}: $log.first")
    fi
    accountFor "$target" "${names[i]}"
  done
}

# Whether a test that ran has passed.
isGood() { # $1 target, $2 name
  local status=1 good=0 bad=1 result
  result=$(logOf "$1" "$2").result
  [[ -f $result ]] && read -r status good bad _ < "$result"
  ((status == 0 && bad == 0))
}

# Counts and prints what a test left beside its log.
accountFor() { # $1 target, $2 name
  local log status=1 good=0 bad=1 seconds=0 skipped=0 computed=0
  log=$(logOf "$1" "$2")
  [[ -f $log.result ]] && read -r status good bad seconds skipped computed < "$log.result"
  account "$1 $2" "$log" "$status" "$good" "$bad" "$seconds" "$skipped" "$computed"
}

# Builds goals of one target ($1), as scripts/build.sh names them; only a failure counts.
buildTests() {
  local log=build/logs/$1.log start=$SECONDS
  mkdir -p build/logs
  scripts/build.sh "$@" 2>&1 | tee "$log"
  if ((PIPESTATUS[0])); then account "build $1" "$log" 1 0 1 $((SECONDS - start)); return 1; fi
  echo "Built the tests of $1 in $((SECONDS - start)) s"
}

# What has to be built for one area: its test program; the programs of the tree if its tests start them.
goalsOf() { # $1 area
  [[ $(find "tests/$1" -name '*.cpp' -print -quit) ]] && echo "test-$1"
  if [[ $(find "tests/$1" -name '*.sh' -print -quit) ]] || grep -rqs PLUMBLINE_BIN "tests/$1"; then echo all; fi
}

# Runs a check of the sources; what it says is shown.
check() {
  local log=build/logs/$1.log
  mkdir -p build/logs
  if "$2" > "$log" 2>&1; then account "$1" "$log" 0 1 0 0; else account "$1" "$log" 1 0 1 0; fi
  cat "$log"
}

# tests/cluster needs big packages and daemons: make cluster.
areasOf() { find tests -mindepth 1 -maxdepth 1 -type d ! -name bench ! -name support ! -name cluster -printf '%f\n' | LC_ALL=C sort; }

if [[ ${1-} == --all ]]; then
  [[ ${SECOND_RUN-} == no ]] || secondRuns=3
  check floors scripts/check_floors.sh
  check sizes scripts/check_sizes.sh
  check sentences scripts/check_sentences.sh
  mapfile -t areas < <(areasOf)
  # The programs as they are used play their scripts, a few of them the sanitized programs, too. Test programs run under the
  # sanitizers, which see more. To build them a second time would cost a third of the whole: scripts/run_tests.sh
  # SimRelease AREA... does it.
  programAreas=("${longAreas[@]}")
  buildTests SimRelease all "${longAreas[@]/#/test-}" && runTarget SimRelease "${areas[@]}"
  programAreas=() goals=() short=()
  # make check has the time to see the long ones there, too, but as short as in make test. Readers of what comes from outside
  # are under the sanitizers in make test as well, by tests/fuzz and the scripts above.
  slow=${PLUMBLINE_SLOW-}
  unset PLUMBLINE_SLOW
  [[ $slow ]] && cpuSeconds=${TEST_CPU_SECONDS:-3600}
  for area in "${areas[@]}"; do
    [[ ! $slow && " ${longAreas[*]} " == *" $area "* ]] && continue
    short+=("$area")
    # The test programs alone: what scripts start is the release's.
    [[ $(find "tests/$area" -name '*.cpp' -print -quit) ]] && goals+=("test-$area")
  done
  for path in "${sanitizedScripts[@]}"; do
    [[ -f tests/$path ]] && goals+=("${sanitizedPrograms[@]}") && break
  done
  scriptsOfTarget() { [[ $1 == SimRelease || " ${sanitizedScripts[*]} " == *" $2 "* ]]; }
  buildTests SimSanitize "${goals[@]}" && runTarget SimSanitize "${short[@]}"
else
  target=SimRelease
  if [[ ${1-} && $'\n'$(scripts/list_targets.sh)$'\n' == *$'\n'$1$'\n'* ]]; then target=$1; shift; fi
  (($#)) || { echo "run_tests.sh: give --all or areas: $(areasOf | tr '\n' ' ')" >&2; exit 2; }
  goals=()
  for area in "$@"; do
    [[ -d tests/$area ]] || { echo "run_tests.sh: no tests/$area; there is: $(areasOf | tr '\n' ' ')" >&2; exit 2; }
    mapfile -t -O ${#goals[@]} goals < <(goalsOf "$area")
  done
  buildTests "$target" "${goals[@]}" && runTarget "$target" "$@"
fi

for log in "${failures[@]}"; do
  echo
  echo "---- $log"
  grep -nE 'Failure|FAILED|ERROR|error|stopped after|\.sh:|runtime error' "$log" | head -20
  tail -5 "$log"
done
if ((${#twice[@]})); then
  echo
  echo "Failed beside other tests and ran once more alone; the result of the second run, and the log of the first:"
  printf '  %s\n' "${twice[@]}"
fi
echo
echo "$passed passed, $failed failed$( ((unsteady)) && echo "; $unsteady of the programs and scripts passed only in a second run")"
((failed == 0 && passed > 0))
