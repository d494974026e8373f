# A running agent is looked into: by a bare connection, by bin/rdb for shells, by scripts, and in its console in a
# terminal (tmux), which stays when the agent goes and comes back.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
for program in tmux gnuplot; do
  command -v $program > /dev/null || fail "no $program: scripts/install_packages.sh scripts/packages-test.txt installs it"
done
export LC_ALL=C.UTF-8 XDG_STATE_HOME="$scratch/state"
"$bin/simulator" --port 0 --monitor-port 0 --ports-file "$scratch/ports.json" --seed 1 --realtime > "$scratch/simulator.log" 2>&1 &
waitFor test -s "$scratch/ports.json"
agentPort=$(sed -n 's/.*"agent": \([0-9]*\).*/\1/p' "$scratch/ports.json")
startAgent() { # port of the debug interface
  rm -f "$scratch/agent.err" # or the last one's words are read
  "$bin/agent" --port "$agentPort" --debug "$1" > "$scratch/agent.out" 2> "$scratch/agent.err" &
  agent=$!
  waitFor grep -q 'debug port' "$scratch/agent.err"
  debugPort=$(sed -n 's/.*debug port 127.0.0.1:\([0-9]*\):.*/\1/p' "$scratch/agent.err")
}
startAgent 0
toAgent=("$bin/rdb" "127.0.0.1:$debugPort")
rdb() { "${toAgent[@]}" "$@"; }
ready() { rdb --exec 'get r:FrameInfo.cycle' > /dev/null 2>&1; }
waitFor ready

# A bare connection, as nc makes one.
exec 3<> "/dev/tcp/127.0.0.1/$debugPort"
printf '#1 get representation:GameState.ownScore\n' >&3
read -r -t 10 line <&3
expectEqual "$line" '#1 representation:GameState.ownScore 0' 'answer on a bare connection'
exec 3>&-

# For shells: values, orders, errors with their status.
expectEqual "$(rdb --exec 'get r:GameState.opponentScore')" 'representation:GameState.opponentScore 0' 'value'
expectError 2 'rdb: nothing is called representation:BalPos; did you mean "representation:BallPos"?' "${toAgent[@]}" --exec 'get r:BalPos'
expectError 2 'rdb: representation:BallPos.relative has no part z; it has x, y' "${toAgent[@]}" --exec 'get r:BallPos.relative.z'
rdb --exec 'set r:BallPos.relative.x 0.5'
expectEqual "$(rdb --exec 'get r:BallPos.relative.x')" 'representation:BallPos.relative.x 0.500000' 'value that was set'
rdb --exec 'unset r:BallPos.relative.x'
expectError 2 'rdb: config:BallLocator.forgetSeconds: BallLocator.forgetSeconds must be within [0, 10000], not -1' "${toAgent[@]}" --exec 'set c:BallLocator.forgetSeconds -1'
[[ $'\n'$(rdb --exec timing) == *$'\nBallLocator:updateLocalBallPos '* ]] || fail "no timing of BallLocator"
rdb --exec 'list m:' | grep -q '^module:BallLocator:forget  response once$' || fail "a site of a module is not listed"
expectEqual "$(rdb --exec 'dr m:AugmentedSelfLocator:forget')" 'module:AugmentedSelfLocator:forget the pose is forgotten' 'response'
[[ $(rdb --exec 'watch r:FrameInfo.cycle every 0.1s' --seconds 1 | grep -c '^representation:FrameInfo.cycle [0-9]*$') -ge 3 ]] || fail "a watch gives no values"
rdb --exec 'watch r:FrameInfo.cycle every 0.1s' --exec 'watch r:FrameInfo.time every 0.1s' --seconds 1 > "$scratch/both"
for part in cycle time; do grep -q "^representation:FrameInfo.$part [0-9]" "$scratch/both" || fail "two watches: no $part"; done
[[ $(rdb --exec 'timing BallLocator:execute' | wc -l) == 3 ]] || fail "timing of one step"
expectError 2 'rdb: plot VALUE [WINDOW [COUNT [SECONDS]]]: the picture is drawn every 0.02 to 3600 seconds, not "0"' "${toAgent[@]}" --exec 'plot r:BallPos.age a 10 0'
rdb --exec 'plot r:BallPos.relative.x ball 30 0.5' --exec 'plot r:BallPos.relative.y ball 30' --png "$scratch/ball.png" > "$scratch/plot.txt"
grep -q '^representation:BallPos.relative.y *\[.*[▁▂▃▄▅▆▇█]' "$scratch/plot.txt" || fail "no sparkline"
expectEqual "$(head -c 4 "$scratch/ball.png" | tail -c 3)" PNG 'format of the picture'
printf '# a script\nset r:BallPos.age 7\nsleep 0.1\nget r:BallPos.age\nunset r:BallPos.age\nget r:BallPox\n' > "$scratch/script"
expectError 2 "rdb: $scratch/script:6: nothing is called representation:BallPox; did you mean \"representation:BallPos\"?" \
  bash -c "'$bin/rdb' 127.0.0.1:$debugPort --script '$scratch/script' > '$scratch/script.out'"
expectEqual "$(cat "$scratch/script.out")" 'representation:BallPos.age 7.000000' 'output of the script'
expectError 2 'rdb: cannot connect to 127.0.0.1:1: Connection refused; was the agent started with --debug?' "$bin/rdb" 127.0.0.1:1 --exec help

# The console.
terminal=(tmux -L "plumbline-rdb-$$" -f /dev/null)
endOthers() { "${terminal[@]}" kill-server 2> /dev/null || true; }
screen() { "${terminal[@]}" capture-pane -p; }
fail() { echo "FAILED: $*; the terminal shows:" >&2; screen >&2 || true; exit 1; }
shows() { screen | grep -q -e "$1"; }
type_() { "${terminal[@]}" send-keys -l "$1"; "${terminal[@]}" send-keys Enter; }
console() { "${terminal[@]}" new-session -d -x 120 -y 30 "$bin/rdb 127.0.0.1:$debugPort; echo ended \$?; sleep 60"; }
console
waitFor shows 'connected to'
type_ 'watch r:FrameInfo.time'
waitFor shows '^representation:FrameInfo.time  [0-9]'
type_ 'get r:GameState.ownScore'
waitFor shows '^representation:GameState.ownScore 0'
"${terminal[@]}" send-keys -l 'get r:BallP'
"${terminal[@]}" send-keys Tab
waitFor shows '^  representation:BallPercept$'
"${terminal[@]}" send-keys -l 'os'
"${terminal[@]}" send-keys Tab
waitFor shows '^  representation:BallPos.relativeVelocity$'
"${terminal[@]}" send-keys C-u
# Tab knows the agent's commands, and what each takes.
"${terminal[@]}" send-keys -l 'rel'
"${terminal[@]}" send-keys Tab
waitFor shows '^rdb> reload *$'
"${terminal[@]}" send-keys -l 'walk'
"${terminal[@]}" send-keys Tab
waitFor shows '^rdb> reload walking$'
"${terminal[@]}" send-keys C-w
waitFor shows '^rdb> reload *$'
"${terminal[@]}" send-keys C-u
# A script, which waits where it says so.
printf '# steps\nset r:BallPos.age 7\nsleep 0.3\nget r:BallPos.age\nunset r:BallPos.age\n' > "$scratch/steps"
type_ "run $scratch/steps"
waitFor shows '^representation:BallPos.age 7'
waitFor shows '^> unset r:BallPos.age'
type_ 'plot r:BallPos.relative.x'
waitFor shows '[▁▂▃▄▅▆▇█]'
# The agent goes and comes back on the same port; what was watched goes on.
kill "$agent"; wait "$agent" || true
waitFor shows 'connection lost; trying again'
startAgent "$debugPort"
waitFor shows 'back at'
waitFor shows '^representation:FrameInfo.time  [0-9]'
"${terminal[@]}" send-keys C-c
waitFor shows 'ended 0'
grep -q '^get r:GameState.ownScore$' "$XDG_STATE_HOME/plumbline/rdb_history" || fail "the history was not kept"
"${terminal[@]}" kill-server
terminal[2]="plumbline-rdb-$$-again" # tmux that is still ending would take the next session with it
console
waitFor shows 'connected to'
"${terminal[@]}" send-keys Up
waitFor shows 'rdb> plot r:BallPos.relative.x'
"${terminal[@]}" send-keys C-c
waitFor shows 'ended 0'

# Where there is a display, a plot has a window of gnuplot's; this one keeps what it is to draw.
"${terminal[@]}" kill-server
terminal[2]="plumbline-rdb-$$-window"
mkdir "$scratch/gnuplot"
printf '#!/bin/sh\nexec cat > "%s"\n' "$scratch/window" > "$scratch/gnuplot/gnuplot"
chmod +x "$scratch/gnuplot/gnuplot"
onDisplay() { "${terminal[@]}" new-session -d -x 120 -y 30 "env DISPLAY=:77 PATH='$1' '$bin/rdb' 127.0.0.1:$debugPort; echo ended \$?; sleep 60"; }
onDisplay "$scratch/gnuplot:$PATH"
waitFor shows 'connected to'
type_ 'plot r:BallPos.relative.x ball'
type_ 'plot r:BallPos.relative.y ball'
drawn() { (($(grep -c '^plot .*relative\.x.*relative\.y' "$scratch/window") >= 3)); } # three times
waitFor drawn
grep -qE '^-?[0-9]+\.[0-9]{7}' "$scratch/window" || fail "a window gets rounded values"
type_ 'plot off ball'
gone() { ! shows '[▁▂▃▄▅▆▇█]'; }
waitFor gone
# The real one draws what was sent, and one without windows says what is missing.
awk '/^plot .*relative\.y/ && !n { n = 1; print; next } n && /^plot/ { exit } n' "$scratch/window" | GNUTERM=dumb gnuplot > "$scratch/drawn" 2> "$scratch/drawn.err" || fail "gnuplot: $(cat "$scratch/drawn.err")"
grep -q 'BallPos.relative.y' "$scratch/drawn" || fail "gnuplot draws nothing"
"${terminal[@]}" send-keys C-c
waitFor shows 'ended 0'
"${terminal[@]}" kill-server
terminal[2]="plumbline-rdb-$$-none"
printf '#!/bin/sh\nexit 3\n' > "$scratch/gnuplot/gnuplot"
onDisplay "$scratch/gnuplot:$PATH"
waitFor shows 'connected to'
type_ 'plot r:BallPos.relative.x ball'
waitFor shows 'plot ball: gnuplot can open no window here: install gnuplot-qt'
echo "rdb: agent on port $debugPort looked into by shell, script and console"
