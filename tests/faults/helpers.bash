# How a job is tried and judged; sourced by scripts/faults.sh, kills.sh and stops.sh in the root of the tree.
patience=600 # seconds until a program counts as hung, also on a machine with much else to do
tree=$PWD
bin=${PLUMBLINE_BIN:-$tree/bin}
scratch=$(mktemp -d)
rows=$scratch/rows library=$scratch/faults.so sample=$scratch/sample
trap 'status=$?; jobs -p | xargs -r kill 2> /dev/null; wait; stopServers; rm -rf "$scratch"; exit $status' EXIT
trap 'exit 130' INT TERM
exec {idle}<> <(:)
pause() { read -r -t "$1" -u "$idle"; } # seconds, without a process of its own
waitFor() { # seconds, command...: until it succeeds; fails if it does not in time
  local i
  for ((i = 0; i < $1 * 100; ++i)); do
    if "${@:2}"; then return 0; fi
    pause 0.01
  done
  return 1
}
hasSaid() { [[ -s $1 ]] || ! kill -0 "$2" 2> /dev/null; } # file, process: it wrote there, or it is gone

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
    [[ -x $bin/${programOf[$word]} ]] || fail "no $bin/${programOf[$word]}"
  done
}

# Makes the library and the folder `out` for the lists of faults.
begin() { # folder
  out=${FAULTS_OUT:-$1}
  mkdir -p "$out"
  out=$(cd "$out" && pwd)
  mkdir "$rows"
  cc -O1 -shared -fPIC -o "$library" tests/faults/faults.c -ldl || fail "the library of faults is not built"
  local name
  for name in "${chosen[@]}"; do
    if needsSample "$name"; then makeSample || fail "no game was recorded: $(tail -1 "$scratch/err")"; break; fi
  done
}

# Calls a function with each chosen job, as many at once as JOBS; each has a folder of its own. It leaves a row of the table
# in `row` and counts in `tries` and `broken`; findings go beside.
playJobs() { # function, file of the table, heading's format and words
  local name format=$3 running=0 atOnce=${JOBS:-$(nproc)} triedHere brokenHere
  printf "$format\n" "${@:4}" | tee "$2"
  for name in "${chosen[@]}"; do
    if ((running == atOnce)); then wait -n; running=$((running - 1)); fi
    (
      trap 'stopServers; exit 143' TERM
      tries=0 broken=0 row=() scratch=$scratch/of/$name
      mkdir -p "$scratch"
      "$1" "$name"
      printf "$format\n" "$name" "${row[@]}" "$broken" | tee "$rows/$name"
      echo "$tries $broken" > "$rows/$name.sums"
      stopServers
      rm -rf "$scratch"
    ) &
    running=$((running + 1))
  done
  wait
  tries=0 broken=0
  for name in "${chosen[@]}"; do
    cat "$rows/$name" >> "$2" 2> /dev/null || { echo "$name: was not tried to its end" >> "$rows/$name.findings"; broken=$((broken + 1)); continue; }
    read -r triedHere brokenHere < "$rows/$name.sums"
    tries=$((tries + triedHere)) broken=$((broken + brokenHere))
  done
  cat "$rows"/*.findings > "$out/findings.txt" 2> /dev/null
}

finding() { # job, fault, what
  broken=$((broken + 1))
  printf '%s %s: %s\n' "$1" "$2" "$3" >> "$rows/$1.findings"
}

# A log of an agent, for jobs that read one; made once.
makeSample() {
  (cd "$tree" && "$bin/game" --seed 8 --limit 2 --output "$scratch/sampled" --agent-option=--log \
    --agent-option="$sample" --agent-option=--log-wait > /dev/null 2> "$scratch/err") || [[ -s $sample/metadata.yaml ]]
}
source tests/faults/servers.bash
needsSample() { declare -f "$1_prepare" "$1_run" | grep -qE '\$sample|startAgent'; }

# Its folder as it is before each try, and a run without a fault to compare with: status, files, how many calls.
prepareJob() {
  local name=$1
  rm -rf "$scratch/template" "$scratch/good" "$scratch/calls" "$scratch/places"
  mkdir "$scratch/template"
  if declare -F "$name"_prepare > /dev/null; then
    (cd "$scratch/template" && ln -sfn "$tree/config" config && "$name"_prepare) 2> "$scratch/err" || return 1
  else
    ln -sfn "$tree/config" "$scratch/template/config"
  fi
  cp -a "$scratch/template" "$scratch/good"
  playJob "$name" "$scratch/good" count
  mv "$scratch/faults" "$scratch/calls" 2> /dev/null || { echo "no calls were counted: $(tail -1 "$scratch/err")" >> "$scratch/err"; return 1; }
  goodStatus=$status
  cp "$scratch/out" "$scratch/good.out"
  expected "$name" "$status" || { echo "status $status without a fault: $(tail -1 "$scratch/err")" >> "$scratch/err"; return 1; }
}
expected() { if declare -F "$1"_expects > /dev/null; then "$1"_expects "$2"; else (($2 == 0)); fi; }
callsOf() { awk -v kind="$1" '$1 == kind { n = $2 } END { print n + 0 }' "$scratch/calls"; }

# Runs a job once in a folder with a fault; leaves its status, $scratch/err and the faults that came in $scratch/faults.
playJob() { # job, folder, fault
  rm -f "$scratch/faults"
  local faulty=() # the library is in every program that the job starts, and works in the one that the job is of
  [[ ! $3 ]] || faulty=(FAULT="$3" FAULT_LOG="$scratch/faults" FAULT_PROGRAM="${programOf[$1]}" FAULT_PATIENCE=$patience
    LD_PRELOAD="$library" ${placesWanted:+FAULT_PLACES="$scratch/places"})
  # Standard output goes to a pipe: it is a terminal's or a pipe's in life, and a file's faults are another matter.
  (cd "$2" && if [[ $3 ]]; then export "${faulty[@]}"; fi && "$1"_run) 2> "$scratch/err" < /dev/null | cat > "$scratch/out"
  status=${PIPESTATUS[0]}
}

# The folder of the next try. The process that writes an agent's crash log may still be at work in the last one.
freshWork() {
  until rm -rf "$scratch/work" 2> /dev/null; do pause 0.02; done
  cp -a "$scratch/template" "$scratch/work"
}

tryKind() { # job, kind
  local name=$1 kind=$2 calls n lasting numbers=()
  calls=$(callsOf "$kind")
  tried=0
  if [[ $kind == malloc ]]; then
    mapfile -t numbers < <(placesToTry)
  else
    for ((n = 1; n <= calls && n <= most; ++n)); do numbers+=("$n"); done
  fi
  for n in "${numbers[@]}"; do
    for lasting in "" $([[ $kind == write ]] && echo +); do tryFault "$name" "$kind:$n$lasting"; done
  done
}
# The first allocation of each place there is; of more than $allocations of them the first third, then evenly among the rest.
placesToTry() {
  awk '{ print $2 }' "$scratch/places" | sort -nu | awk -v most="$allocations" '
    { n[NR] = $1 }
    END {
      if (NR <= most) for (i = 1; i <= NR; ++i) print n[i]
      else {
        first = int(most / 3)
        for (i = 1; i <= first; ++i) print n[i]
        for (i = 1; i <= most - first; ++i) print n[first + int(i * (NR - first) / (most - first))]
      }
    }'
}
placesOf() { sort -u "$scratch/places" 2> /dev/null | wc -l; }

tryFault() { # job, fault
  local name=$1 file last program=${programOf[$1]}
  freshWork
  playJob "$name" "$scratch/work" "$2"
  [[ -s $scratch/faults ]] || return 0 # fewer calls than in the run before, which is no matter
  tries=$((tries + 1)) tried=$((tried + 1))
  if ((status == 137 || status == 142 || status == 143)); then finding "$name" "$2" "hangs"; return; fi
  if ((status >= 128 && status != 130)); then finding "$name" "$2" "dies by signal $((status - 128)): $(tail -1 "$scratch/err")"; return; fi
  last=$(grep -a "^$program: " "$scratch/err" | tail -1)
  if ((status != goodStatus)); then
    if [[ ! $last || ${#last} -lt $((${#program} + 8)) ]]; then
      finding "$name" "$2" "status $status without a line that says why: $(tail -1 "$scratch/err")"
    elif grep -aqE 'bad_alloc|terminate called|json\.exception|basic_string|filesystem error|unknown exception' "$scratch/err"; then
      finding "$name" "$2" "an error in a library's words: $(grep -aE 'bad_alloc|terminate called|json|basic_string|filesystem error|unknown' "$scratch/err" | tail -1)"
    fi
  fi
  judgeFiles "$name" "$2"
  if declare -F "$name"_prints > /dev/null && ((status == goodStatus)) && [[ ! $last ]]; then
    cmp -s "$scratch/out" "$scratch/good.out" || finding "$name" "$2" "status $status and no word, but it prints other text"
  fi
  if declare -F "$name"_check > /dev/null; then
    (cd "$scratch/work" && "$name"_check) > "$scratch/checked" 2>&1 || finding "$name" "$2" "status $status, and what was written cannot be used: $(tail -1 "$scratch/checked")"
  fi
  file=$(find "$scratch/work" -name '*.part' | head -1)
  [[ ! $file ]] || finding "$name" "$2" "leaves ${file#"$scratch/work/"}"
}

# After a kill: no file half written, recordings readable, and what resumes comes to the same. `readable`, `resumed` and
# `states`, the folders that were gone on with, are the caller's.
judgeAfterKill() { # job, fault
  local name=$1 file after=killed
  ((status == 137)) || after=$status # a process that it had made of itself was killed, and it went on without
  status=$after judgeFiles "$name" "$2"
  if declare -F "$name"_check > /dev/null; then
    if (cd "$scratch/work" && "$name"_check) > "$scratch/checked" 2>&1; then readable=$((readable + 1))
    else finding "$name" "$2" "what was written cannot be used: $(tail -1 "$scratch/checked")"; fi
  fi
  declare -F "$name"_resumes > /dev/null || return 0
  # The same command in the same folder does the same: each folder that a kill left is gone on with once.
  local left
  left=$(cd "$scratch/work" && find . -type f -exec sha1sum {} + | LC_ALL=C sort | sha1sum)
  if [[ ${states[$left]-} ]]; then resumed=$((resumed + 1)); return; fi
  playJob "$name" "$scratch/work" ""
  if ! expected "$name" "$status"; then finding "$name" "$2" "the same command again: status $status, $(tail -1 "$scratch/err")"; return; fi
  for file in $("$name"_resumes); do
    cmp -s <(comparable "$scratch/work/$file") <(comparable "$scratch/good/$file") ||
      { finding "$name" "$2" "gone on with, it comes to another $file"; return; }
  done
  states[$left]=1
  resumed=$((resumed + 1))
}
# A file without the comments, which count what was run.
comparable() { [[ $1 == *.yaml ]] && grep -v '^#' "$1" || cat "$1"; }

judgeFiles() { # job, fault
  declare -F "$1"_outputs > /dev/null || return 0
  local file
  for file in $("$1"_outputs); do # with a question mark: its content differs from run to run
    judgeFile "$1" "$2" "${file%\?}" "$([[ $file == *\? ]] && echo differs)"
  done
}
judgeFile() { # job, fault, file, differs
  local new=$scratch/work/$3 old=$scratch/template/$3 good=$scratch/good/$3
  if [[ ! -e $good ]]; then return; fi
  if [[ $status == "$goodStatus" ]] && ! grep -aq "^${programOf[$1]}: " "$scratch/err"; then
    if [[ $4 ]]; then [[ -s $new ]] || finding "$1" "$2" "status $status, but no $3"
    else cmp -s "$new" "$good" || finding "$1" "$2" "status $status and no word, but $3 is not what it should be"; fi
  elif [[ -e $new ]]; then
    cmp -s "$new" "$old" || cmp -s "$new" "$good" || { [[ $4 ]] && tail -c 8 "$new" | grep -qE '(\}|</svg>)$'; } ||
      finding "$1" "$2" "status $status, and $3 is half written"
  elif [[ -e $old ]]; then
    finding "$1" "$2" "status $status, and the old $3 is gone"
  fi
}

# What jobs check with and start beside.
readableLog() { # of one that came to nothing there is nothing to read
  [[ -s $1/$1_0.db3 ]] || return 0
  local said
  said=$("$bin/logtool" list "$1" 2>&1) && return
  echo "$said"
  [[ $said == *'has no table'* ]]
}
readableMatch() {
  [[ -s $1 ]] || return 0
  "$bin/webmonitor" --replay "$1" --web-port 0 > replay.out 2> replay.err & # reads the whole index first
  local player=$!
  waitFor 10 hasSaid replay.out $player
  kill -INT $player 2> /dev/null
  wait $player 2> /dev/null
  local result=$?
  rm -f replay.out
  cat replay.err
  ((result == 0)) || grep -q 'nothing is recorded in it' replay.err || (( $(stat -c %s "$1") < 32 )) # not even a heading
}
visitedAfterStart() { local visitor=visit; stopAfterStart "$@"; }
# Asks for the page whose address a program has printed, and for what is sent to it from then on, without a browser.
visit() { # file of its first lines
  local port wire
  port=$(sed -n 's#.*http://localhost:\([0-9]*\)/.*#\1#p' "$1")
  [[ $port ]] && { exec {wire}<> "/dev/tcp/127.0.0.1/$port"; } 2> /dev/null || return 0
  printf 'GET / HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n' >&$wire 2> /dev/null
  timeout 2 cat <&$wire > /dev/null 2>&1
  exec {wire}>&-
  { exec {wire}<> "/dev/tcp/127.0.0.1/$port"; } 2> /dev/null || return 0
  printf 'GET / HTTP/1.1\r\nHost: localhost\r\nConnection: Upgrade\r\nUpgrade: websocket\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Protocol: plumbline\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n\r\n' >&$wire 2> /dev/null
  timeout 0.1 cat <&$wire > /dev/null 2>&1
  exec {wire}>&-
}
portIn() { sed -n 's/.*"'"$2"'": *\([0-9]*\).*/\1/p' "$1"; }
stopAfterStart() { # seconds, command...: interrupts it so long after its first line, however long that took
  local result
  env --default-signal=INT "${@:2}" > started.out & # a shell's background programs ignore it, until they catch it
  local program=$!
  waitFor $patience hasSaid started.out $program
  [[ ! ${visitor-} ]] || $visitor started.out
  pause "$1"
  # A second signal would end at once a program that `make stops` has stopped already.
  [[ ${stopped-} && -s $scratch/faults ]] || kill -INT $program 2> /dev/null
  wait $program
  result=$?
  rm -f started.out
  return $result
}
