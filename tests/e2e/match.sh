# scripts/match.sh brings two teams onto the field, ends in time, and by Ctrl-C within a second with nothing left behind.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
match=scripts/match.sh
"$match" --help | grep -q '^usage: make match' || fail "no help"
expectError 2 "match.sh: --left '12' is not 0 to 11; see match.sh --help" "$match" --left 12
expectError 2 "match.sh: unknown option --fats; see match.sh --help" "$match" --fats
expectError 2 "match.sh: nobody is to play; see match.sh --help" "$match" --left 0 --right 0
expectError 2 "match.sh: both teams are called A; see match.sh --help" "$match" --left-name A --right-name A

# Without a terminal, to its end, in real time so that its first second is seen; TMPDIR tells what is left behind.
mkdir "$scratch/tmp"
TMPDIR=$scratch/tmp within 60 "$match" --left 2 --right 1 --seconds 3 --no-page --realtime --seed 1 > "$scratch/out" 2> "$scratch/err" ||
  fail "a short match: status $?, $(cat "$scratch/err")"
head -1 "$scratch/out" | grep -qx 'Plumbline (2) against Line (1), 3 s' || fail "it says: $(head -1 "$scratch/out")"
grep -qx '0:00.* Plumbline 0 : 0 Line KickOff_Left half 1 robots 3' "$scratch/out" || fail "no play-by-play: $(cat "$scratch/out")"
tail -1 "$scratch/out" | grep -qx 'at the end: Plumbline [0-9]* : [0-9]* Line' || fail "no score: $(tail -1 "$scratch/out")"
[[ -z $(ls -A "$scratch/tmp") ]] || fail "left behind: $(ls "$scratch/tmp")"

# Ctrl-C, in the middle of the start and in the game.
for when in 'against' 'on their way'; do
  mark=match$RANDOM
  # Not ignoring SIGINT as what a script starts in the background does, and in a group of its own.
  python3 - "$scratch/ctrl" "$match" --left 3 --right 2 --no-page --realtime --left-name "$mark" << 'END' &
import os, signal, sys
signal.signal(signal.SIGINT, signal.default_int_handler)
os.setsid()
out = os.open(sys.argv[1], os.O_CREAT | os.O_WRONLY | os.O_TRUNC, 0o644)
os.dup2(out, 1); os.dup2(out, 2)
signal.signal(signal.SIGINT, signal.SIG_DFL)
os.execv(sys.argv[2], sys.argv[2:])
END
  pid=$!
  waitFor grep -q "$when" "$scratch/ctrl"
  begin=$(date +%s%N)
  kill -INT -- "-$pid"
  status=0
  wait $pid || status=$?
  passed=$((($(date +%s%N) - begin) / 1000000))
  expectEqual "$status" 130 "status after Ctrl-C"
  [[ -z $(pgrep -f -- "--team $mark") ]] || fail "robots are left behind"
  left=$(ps -eo pgid=,stat=,args= | awk -v group=$pid '$1 == group && $2 !~ /^Z/')
  [[ -z $left ]] || fail "processes are left behind: $left"
  echo "Ctrl-C ended it after $passed ms"
done
