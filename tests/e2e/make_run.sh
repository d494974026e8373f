# `make run`, typed in a terminal: it says where the page is, plays in real time, and the page stays after the goal. Ctrl-C, in the
# game or later, ends it within a second, and no process is left.
[[ ${PLUMBLINE_TARGET:-SimRelease} == SimRelease ]] || { echo "left out: make run is about the programs of SimRelease"; exit 0; }
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
scripts/build_page.sh || fail "the page could not be built"
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES V
export LC_ALL=C
mkfifo "$scratch/keys"
exec 5<> "$scratch/keys"

# Leaves what the terminal shows in a file, and the session of what runs in it.
endOthers() { [[ ! ${session-} ]] || pkill -KILL -s "$session"; }
isThere() { session=$(pgrep -P "$terminal"); }
type() { # name
  # exec: the shell that `script` starts, which may be any, must not be what Ctrl-C ends. TERM: a cron job has none
  TERM=${TERM:-dumb} script -qefc "exec make run ARGS='--output $scratch/$1'" /dev/null <&5 > "$scratch/$1.txt" 2> "$scratch/err" &
  terminal=$!
  waitFor isThere
}
shows() { tr -d '\r' < "$scratch/$1.txt" | grep -q "$2"; }
says() { waitFor shows "$@"; } # name, pattern
nothingRuns() { ! pgrep -s "$session" > /dev/null; }

# Ctrl-C; a second to the end, more on a busy machine.
ctrlC() { # leaves the status
  local before=${EPOCHREALTIME/./} took limit
  limit=$(awk -v cores="$(nproc)" '{ print int(1e6 * ($1 > cores ? $1 / cores : 1)) }' /proc/loadavg)
  printf '\003' >&5
  status=0
  wait $terminal || status=$?
  took=$((${EPOCHREALTIME/./} - before))
  ((took < limit)) || fail "make run took $took us to its end by Ctrl-C"
  waitFor nothingRuns
  session=""
}

# In the game. Real time: the second second of the game does not come within one of ours after the first.
type early
says early '^watch at http://localhost:[0-9]*/$'
says early '^    1 s  robot .*  KickOff_Left  going to kick$'
first=${EPOCHREALTIME/./}
says early '^    3 s  robot '
second=${EPOCHREALTIME/./}
((second - first > 1000000)) || fail "two seconds of the game took $((second - first)) us: no real time"
ctrlC
expectEqual $status 2 "make's status after Ctrl-C in the game"
shows early 'game: interrupted$' || fail "nothing says that it was interrupted: $(cat "$scratch/early.txt")"
[[ -s $scratch/early/summary.json ]] || fail "no summary of what was played"

# After the goal, with the page still there.
type late
says late '^goal after [0-9.]* s; the page stays on the last picture: press Ctrl-C to end$'
python3 - "$(tr -d '\r' < "$scratch/late.txt" | sed -n 's/^watch at //p')" << 'END' || fail "the page is dead after the goal"
import sys, urllib.request
assert b"Plumbline" in urllib.request.urlopen(sys.argv[1], timeout=20).read()
END
ctrlC
expectEqual $status 0 "make's status after Ctrl-C on the last picture"
shows late 'goal after [0-9.]* s, [0-9]* falls; .*/summary.json, .*/track.svg$' || fail "no last line: $(cat "$scratch/late.txt")"
