# What the end-to-end tests share: the programs, a scratch folder that goes at the end, and checks that say what
# they expected.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../support/far-off.bash"
bin=${PLUMBLINE_BIN:-$(cd "$(dirname "${BASH_SOURCE[0]}")/../../bin" && pwd)}
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
scratch=$(mktemp -d)
# What a test has to end besides its own jobs; a test defines it anew.
endOthers() { :; }
# Whoever still runs is ended, and has ended before the folder goes that it writes to.
cleanUp() {
  local status=$? i
  endOthers || true
  jobs -p | xargs -r kill 2> /dev/null || true
  for ((i = 0; i < 100; ++i)); do [[ $(jobs -pr) ]] || break; sleep 0.05; done
  jobs -p | xargs -r kill -9 2> /dev/null || true
  for ((i = 0; i < 200; ++i)); do rm -rf "$scratch" 2> /dev/null && break; sleep 0.05; done
  exit "$status"
}
trap cleanUp EXIT

fail() { echo "FAILED: $*" >&2; exit 1; }
# The value of a key of a flat JSON file.
value() { sed -n 's/^ *"'"$2"'": *\([^,]*\),\{0,1\}$/\1/p' "$1"; }
expectEqual() { [[ $1 == "$2" ]] || fail "$3: expected '$2', got '$1'"; }
# Runs a command that must end with a status and print one line to standard error.
expectError() { # status, line, command...
  local status=$1 line=$2 got=0 text
  shift 2
  text=$(within 60 "$@" 2>&1 > /dev/null < /dev/null) || got=$?
  expectEqual "$got" "$status" "status of '$*'"
  expectEqual "$text" "$line" "message of '$*'"
}
# Waits for a command to succeed.
waitFor() { comesTrue "$@" || fail "waited in vain for: $*"; }
# Waits for a process that was sent a signal to end. It may compute for two seconds, and be there for 200 looks, four seconds,
# at which neither it nor a child wants to go on: that it waits for the processor is no failure.
endsAfter() { # signal that it was sent, pid, what
  local looks=0 before end=$((SECONDS + farOff)); before=$(computed "$2")
  while kill -0 "$2" 2> /dev/null; do
    (($(computed "$2") - before <= 200)) || fail "$3 computes on after SIG$1"
    wantsToGoOn "$2" || looks=$((looks + 1))
    ((looks < 200 && SECONDS < end)) || fail "$3 does not end by SIG$1"
    sleep 0.02
  done
}
endsBy() { kill "-$1" "$2"; endsAfter "$@"; } # signal, pid, what
# bin/gap, with what it says in $scratch/out and err.
gap() { within 240 "$bin/gap" "$@" > "$scratch/out" 2> "$scratch/err" || fail "gap $*: $(cat "$scratch/err")"; }
