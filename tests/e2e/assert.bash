# What the end-to-end tests share: the programs, a scratch folder that goes at the end, and checks that say what
# they expected.
set -euo pipefail
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
# Runs a program that may compute for so many seconds. The clock on the wall ends only what waits for ever: a busy machine
# is no failure.
within() { # seconds, command...
  (ulimit -S -t "$1"; exec timeout 1800 "${@:2}")
}
# How long a process and its threads have computed until now, in hundredths of a second.
computed() { awk '{ sub(/.*\) /, ""); print $12 + $13 }' "/proc/$1/stat" 2> /dev/null || echo 0; }
# Runs a command that must end with a status and print one line to standard error.
expectError() { # status, line, command...
  local status=$1 line=$2 got=0 text
  shift 2
  text=$(within 60 "$@" 2>&1 > /dev/null < /dev/null) || got=$?
  expectEqual "$got" "$status" "status of '$*'"
  expectEqual "$text" "$line" "message of '$*'"
}
# Waits up to two minutes for a command to succeed.
waitFor() {
  local i
  for ((i = 0; i < 2400; ++i)); do "$@" > /dev/null 2>&1 && return 0; sleep 0.05; done
  fail "waited in vain for: $*"
}
# bin/gap, with what it says in $scratch/out and err.
gap() { within 240 "$bin/gap" "$@" > "$scratch/out" 2> "$scratch/err" || fail "gap $*: $(cat "$scratch/err")"; }
