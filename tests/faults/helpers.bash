# How a job is tried and judged; sourced by scripts/faults.sh and scripts/kills.sh in the root of the tree.
patience=600 # seconds until a program counts as hung, also on a machine with much else to do
tree=$PWD
realBin=${PLUMBLINE_BIN:-$tree/bin}
scratch=$(mktemp -d)
trap 'status=$?; jobs -p | xargs -r kill 2> /dev/null; rm -rf "$scratch"; exit $status' EXIT
trap 'exit 130' INT TERM
library=$scratch/faults.so sample=$scratch/sample bin=$scratch/bin

# Fills `chosen` with the jobs that the command line names, or all.
chooseJobs() {
  local word
  chosen=()
  for word in "$@"; do
    case $word in
      --quick) chosen+=("${quick[@]}") ;;
      --list) printf '%s\n' "${jobs[@]}"; exit 0 ;;
      -*) fail "no option $word; see ${0##*/} --help" ;;
      *) [[ ${programOf[$word]-} ]] || fail "no job $word; there is ${jobs[*]}"; chosen+=("$word") ;;
    esac
  done
  ((${#chosen[@]})) || chosen=("${jobs[@]}")
  for word in "${chosen[@]}"; do
    [[ -x $realBin/${programOf[$word]} ]] || fail "no $realBin/${programOf[$word]}"
  done
}

# Makes the library and the folder `out` of what is told.
begin() {
  out=${FAULTS_OUT:-build/faults}
  mkdir -p "$out"
  out=$(cd "$out" && pwd)
  : > "$out/findings.txt"
  cc -O1 -shared -fPIC -o "$library" tests/faults/faults.c -ldl || fail "the library of faults is not built"
  makeWrappers
}

finding() { # job, fault, what
  broken=$((broken + 1))
  printf '%s %s: %s\n' "$1" "$2" "$3" >> "$out/findings.txt"
}

# What stands in the place of the programs: with a fault where $FAULT_NOW says so.
makeWrappers() {
  local path
  mkdir -p "$bin"
  for path in "$realBin"/*; do
    [[ -f $path && -x $path && $path != *.sh ]] || continue
    printf '#!/bin/bash\n[[ ${FAULT_NOW-} ]] || exec "%s" "$@"\n' "$path" > "$bin/${path##*/}"
    printf 'exec timeout --preserve-status -k 5 %s env LD_PRELOAD="%s" FAULT=$FAULT_NOW FAULT_LOG="%s" FAULT_PROGRAM=%s "%s" "$@"\n' \
      $patience "$library" "$scratch/told" "${path##*/}" "$path" >> "$bin/${path##*/}"
    chmod +x "$bin/${path##*/}"
  done
}

# A log of an agent, for jobs that read one; made once.
makeSample() {
  [[ -d $sample ]] || (cd "$tree" && "$bin/game" --seed 8 --limit 2 --output "$scratch/sampled" --agent-option=--log \
    --agent-option="$sample" --agent-option=--log-wait > /dev/null 2> "$scratch/err") || [[ -s $sample/metadata.yaml ]]
}
needsSample() { declare -f "$1_prepare" | grep -q '\$sample'; }

# Its folder as it is before each try, and a run without a fault to compare with: status, files, how many calls.
prepareJob() {
  local name=$1
  rm -rf "$scratch/template" "$scratch/good" "$scratch/calls"
  mkdir "$scratch/template"
  if declare -F "$name"_prepare > /dev/null; then
    if needsSample "$name"; then makeSample || return 1; fi
    (cd "$scratch/template" && ln -sfn "$tree/config" config && "$name"_prepare) 2> "$scratch/err" || return 1
  else
    ln -sfn "$tree/config" "$scratch/template/config"
  fi
  cp -a "$scratch/template" "$scratch/good"
  playJob "$name" "$scratch/good" count
  mv "$scratch/told" "$scratch/calls" 2> /dev/null || { echo "no calls were counted: $(tail -1 "$scratch/err")" >> "$scratch/err"; return 1; }
  goodStatus=$status
  expected "$name" "$status" || { echo "status $status without a fault: $(tail -1 "$scratch/err")" >> "$scratch/err"; return 1; }
}
expected() { if declare -F "$1"_expects > /dev/null; then "$1"_expects "$2"; else (($2 == 0)); fi; }
callsOf() { awk -v kind="$1" '$1 == kind { n = $2 } END { print n + 0 }' "$scratch/calls"; }

# Runs a job once in a folder with a fault; leaves its status, $scratch/err and the faults that came in $scratch/told.
playJob() { # job, folder, fault
  rm -f "$scratch/told"
  # Standard output goes to a pipe: it is a terminal's or a pipe's in life, and a file's faults are another matter.
  (cd "$2" && export FAULT_NOW=$3 && "$1"_run) 2> "$scratch/err" < /dev/null | cat > "$scratch/out"
  status=${PIPESTATUS[0]}
}

tryKind() { # job, kind
  local name=$1 kind=$2 calls n lasting numbers=() step
  calls=$(callsOf "$kind")
  tried=0
  if [[ $kind == malloc ]]; then
    for ((n = 1; n <= allocations; ++n)); do
      # The first ones one by one, then evenly over all there are.
      step=$((n <= allocations / 3 ? n : n * calls / allocations))
      ((step >= 1 && step <= calls)) && numbers+=("$step")
    done
  else
    for ((n = 1; n <= calls && n <= most; ++n)); do numbers+=("$n"); done
  fi
  for n in "${numbers[@]}"; do
    for lasting in "" $([[ $kind == write ]] && echo +); do tryFault "$name" "$kind:$n$lasting"; done
  done
}

tryFault() { # job, fault
  local name=$1 file wanted last program=${programOf[$1]}
  rm -rf "$scratch/work"
  cp -a "$scratch/template" "$scratch/work"
  playJob "$name" "$scratch/work" "$2"
  [[ -s $scratch/told ]] || return 0 # fewer calls than in the run before, which is no matter
  tries=$((tries + 1)) tried=$((tried + 1))
  if ((status == 124 || status == 137 || status == 143)); then finding "$name" "$2" "hangs"; return; fi
  if ((status >= 128 && status != 130)); then finding "$name" "$2" "dies by signal $((status - 128)): $(tail -1 "$scratch/err")"; return; fi
  last=$(grep -a "^$program: " "$scratch/err" | tail -1)
  if ((status != goodStatus)); then
    if [[ ! $last || ${#last} -lt $((${#program} + 8)) ]]; then
      finding "$name" "$2" "status $status without a line that says why: $(tail -1 "$scratch/err")"
    elif grep -aqE 'bad_alloc|terminate called|json\.exception|basic_string|filesystem error|unknown exception' "$scratch/err"; then
      finding "$name" "$2" "an error in a library's words: $(grep -aE 'bad_alloc|terminate called|json|basic_string|filesystem error|unknown' "$scratch/err" | tail -1)"
    fi
  fi
  if declare -F "$name"_outputs > /dev/null; then
    for file in $("$name"_outputs); do
      wanted=${file%\?} # with a question mark: its content differs from run to run
      judgeFile "$name" "$2" "$wanted" "$([[ $file == *\? ]] && echo differs)"
    done
  fi
  if declare -F "$name"_check > /dev/null; then
    (cd "$scratch/work" && "$name"_check) > "$scratch/checked" 2>&1 || finding "$name" "$2" "status $status, and what was written cannot be used: $(tail -1 "$scratch/checked")"
  fi
  file=$(find "$scratch/work" -name '*.part' | head -1)
  [[ ! $file ]] || finding "$name" "$2" "leaves ${file#"$scratch/work/"}"
}

# After a kill: no file half written, recordings readable, and what resumes comes to the same.
judgeAfterKill() { # job, fault
  local name=$1 file
  if declare -F "$name"_outputs > /dev/null; then
    for file in $("$name"_outputs); do
      status=killed judgeFile "$name" "$2" "${file%\?}" "$([[ $file == *\? ]] && echo differs)"
    done
  fi
  if declare -F "$name"_check > /dev/null; then
    if (cd "$scratch/work" && "$name"_check) > "$scratch/checked" 2>&1; then readable=$((readable + 1))
    else finding "$name" "$2" "what was written cannot be used: $(tail -1 "$scratch/checked")"; fi
  fi
  declare -F "$name"_resumes > /dev/null || return 0
  playJob "$name" "$scratch/work" ""
  if ! expected "$name" "$status"; then finding "$name" "$2" "the same command again: status $status, $(tail -1 "$scratch/err")"; return; fi
  for file in $("$name"_resumes); do
    cmp -s <(comparable "$scratch/work/$file") <(comparable "$scratch/good/$file") ||
      { finding "$name" "$2" "gone on with, it comes to another $file"; return; }
  done
  resumed=$((resumed + 1))
}
# A file without the comments, which count what was run.
comparable() { [[ $1 == *.yaml ]] && grep -v '^#' "$1" || cat "$1"; }

judgeFile() { # job, fault, file, differs
  local new=$scratch/work/$3 old=$scratch/template/$3 good=$scratch/good/$3
  if [[ ! -e $good ]]; then return; fi
  if [[ $status == "$goodStatus" ]] && ! grep -aq "^${programOf[$1]}: " "$scratch/err"; then
    if [[ $4 ]]; then [[ -s $new ]] || finding "$1" "$2" "status $status, but no $3"
    else cmp -s "$new" "$good" || finding "$1" "$2" "status $status and no word, but $3 is not what it should be"; fi
  elif [[ -e $new ]]; then
    cmp -s "$new" "$old" || cmp -s "$new" "$good" || { [[ $4 ]] && [[ $(tail -c 2 "$new" | tr -d '\n') == '}' ]]; } ||
      finding "$1" "$2" "status $status, and $3 is half written"
  elif [[ -e $old ]]; then
    finding "$1" "$2" "status $status, and the old $3 is gone"
  fi
}

# What jobs check with and start beside.
readableLog() { # of one that came to nothing there is nothing to read
  [[ -s $1/$1_0.db3 ]] || return 0
  local said
  said=$("$realBin/logtool" list "$1" 2>&1) && return
  echo "$said"
  [[ $said == *'has no table'* ]]
}
readableMatch() {
  [[ -s $1 ]] || return 0
  "$realBin/webmonitor" --replay "$1" --web-port 0 > replay.out 2> replay.err & # reads the whole index first
  local player=$! i
  for ((i = 0; i < 200; ++i)); do
    if [[ -s replay.out ]] || ! kill -0 $player 2> /dev/null; then break; fi
    sleep 0.05
  done
  kill -INT $player 2> /dev/null
  wait $player 2> /dev/null
  local result=$?
  rm -f replay.out
  cat replay.err
  ((result == 0)) || grep -q 'nothing is recorded in it' replay.err || (( $(stat -c %s "$1") < 32 )) # not even a heading
}
portIn() { sed -n 's/.*"'"$2"'": *\([0-9]*\).*/\1/p' "$1"; }
stopAfterStart() { # seconds, command...: interrupts it so long after its first line, however long that took
  local i result
  "${@:2}" > started.out &
  local program=$!
  for ((i = 0; i < patience * 20; ++i)); do
    if [[ -s started.out ]] || ! kill -0 $program 2> /dev/null; then break; fi
    sleep 0.05
  done
  sleep "$1"
  # The program, not the timeout that may stand before it: that one sends a signal twice, and a second one ends it at once.
  kill -INT $(ps -o pid= --ppid $program || echo $program) 2> /dev/null
  wait $program
  result=$?
  rm -f started.out
  return $result
}
withSimulator() { # command with PORT
  local i result
  "$realBin/simulator" --port 0 --monitor-port 0 --wait-agents 0 --realtime --max-seconds 60 --ports-file sim.ports > /dev/null 2>&1 &
  local server=$!
  for ((i = 0; i < 400; ++i)); do [[ -s sim.ports ]] && break; sleep 0.05; done
  "${@/#PORT/$(portIn sim.ports monitor)}"
  result=$?
  kill $server 2> /dev/null
  wait $server 2> /dev/null
  rm -f sim.ports
  return $result
}
withAgent() { # command with PORT
  local i result port
  "$realBin/agent" --replay log --paused --debug 0 --crash-log crash.log > /dev/null 2> agent.err &
  local server=$!
  for ((i = 0; i < 400; ++i)); do grep -q 'debug port' agent.err && break; sleep 0.05; done
  port=$(sed -n 's/.*debug port 127.0.0.1:\([0-9]*\).*/\1/p' agent.err)
  "${@/PORT/$port}"
  result=$?
  kill $server 2> /dev/null
  wait $server 2> /dev/null
  return $result
}
