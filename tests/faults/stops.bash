# How a program must end by SIGINT or SIGTERM; sourced by scripts/stops.sh after helpers.bash.
# From the signal to the end [us]: a second, and as much longer as the machine has more to run than cores.
longest() { awk -v cores="$(nproc)" '{ print int(1e6 * ($1 > cores ? $1 / cores : 1)) }' /proc/loadavg; }

noted() { awk -v what="$1" '$1 == what { n = $2 } END { print n == "" ? 0 : n }' "$scratch/faults"; }

# Plays a job with a signal; leaves `took`, from the signal to the program's end [us].
playStop() { # job, place, signal
  rm -rf "$scratch/tmp"
  freshWork
  mkdir "$scratch/tmp"
  TMPDIR=$scratch/tmp playJob "$1" "$scratch/work" "$2^$3"
  local ended=${EPOCHREALTIME/./}
  [[ -s $scratch/faults ]] || return 1 # it ended before it came there
  # A program that the signal itself ends writes no time: then it is the shell's, with what it does besides.
  (($(noted ended) == 0)) || ended=$(noted ended)
  took=$((ended - $(noted sent)))
}

# Another try of what took too long shows whether the program or the machine was slow.
playStopAgain() { # job, place, signal
  local first=$took i
  slow=$((slow + 1))
  for ((i = 0; i < 2; ++i)); do
    playStop "$@" || continue # it did not come there this time
    (($(noted cpu) <= 1000000)) || break
    ((took > $(longest))) || return 0
  done
  finding "$1" "$2^$3" "ends $((first / 1000)) ms after the signal, and as late when tried again"
}

# Whatever has this job's library.
processesLeft() { grep -lazxs "FAULT_LOG=$scratch/faults" /proc/[0-9]*/environ | xargs -r grep -lazxs "LD_PRELOAD=$library"; }
noneLeft() { [[ ! $(processesLeft) ]]; }

filesOf() { (cd "$1" && find . -mindepth 1 | LC_ALL=C sort); }
# Files that neither were there before nor are the work's.
filesLeft() {
  comm -13 <(cat <(filesOf "$scratch/template") <(filesOf "$scratch/good") | LC_ALL=C sort -u) <(filesOf "$scratch/work") |
    if declare -F "$1"_keeps > /dev/null; then grep -vxE "$("$1"_keeps)"; else cat; fi
  filesOf "$scratch/tmp"
}

judgeStop() { # job, place, signal
  local name=$1 fault=$2^$3 program=${programOf[$1]} bySignal=143 file ends=" $goodStatus "
  [[ $3 == TERM ]] || bySignal=130
  declare -F "$name"_ends > /dev/null && ends+="$("$name"_ends) "
  if (($(noted caught) == 0 && status == bySignal)); then
    uncaught=$((uncaught + 1)) # before the program had begun its work, or after it
  elif ((status == 130)); then
    grep -aqE "^$program: .*(stopped|interrupted|terminated)" "$scratch/err" ||
      finding "$name" "$fault" "status 130 without a line that says that it was stopped: $(tail -1 "$scratch/err")"
  elif [[ $ends != *" $status "* ]]; then
    finding "$name" "$fault" "ends with status $status: $(tail -1 "$scratch/err")"
  fi
  (($(noted cpu) <= 1000000)) || finding "$name" "$fault" "computes for $(($(noted cpu) / 1000)) ms after the signal"
  waitFor $(($(longest) / 1000000)) noneLeft || finding "$name" "$fault" "leaves a process: $(tr '\0' ' ' < "$(processesLeft | head -1 | sed 's/environ$/cmdline/')" 2> /dev/null)"
  file=$(filesLeft "$name" | head -3 | tr '\n' ' ')
  [[ ! $file ]] || finding "$name" "$fault" "status $status, and it leaves $file"
  judgeAfterKill "$name" "$fault"
}
