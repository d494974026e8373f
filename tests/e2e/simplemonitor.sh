# The field in a terminal: 22 robots of a running simulator, over both ports, in terminals of two sizes, and what it
# costs. tmux is the terminal; its screen is what a person would see.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
for program in node tmux; do
  command -v $program > /dev/null || fail "no $program: scripts/install_packages.sh scripts/packages-test.txt installs it"
done
export LC_ALL=C.UTF-8
"$bin/simulator" --port 0 --monitor-port 0 --field-port 0 --ports-file "$scratch/ports.json" --seed 1 > "$scratch/simulator.log" 2>&1 &
simulator=$!
waitFor test -s "$scratch/ports.json"
port() { sed -n 's/.*"'"$1"'": \([0-9]*\).*/\1/p' "$scratch/ports.json"; }
node tests/e2e/web/dummies.mjs "$(port agent)" > "$scratch/dummies.log" 2>&1 &
waitFor grep -q 'all there' "$scratch/dummies.log"

# A server for each terminal: one that is just ending would take the next terminal down with it.
terminals=0
freshTerminal() { terminal=(tmux -L "plumbline-$$-$((++terminals))" -f /dev/null); }
freshTerminal
endOthers() { "${terminal[@]}" kill-server 2> /dev/null || true; }
screen() { "${terminal[@]}" capture-pane -p; }
shows() { screen | grep -q "$1"; }
# Every robot is on the screen: its number with the arrow, in the colour of its team (blue and red grounds).
expectRobots() {
  local unum colours
  colours=$("${terminal[@]}" capture-pane -e -p)
  for unum in 1 2 3 4 5 6 7 8 9 10 11; do
    (($(screen | grep -oE "(^|[^0-9:.])$unum[→↗↑↖←↙↓↘×]" | wc -l) == 2)) || { screen; fail "robots $unum at $1"; }
    for team in '44' '41'; do
      grep -qP "\e\[[0-9;]*${team}m$unum[→↗↑↖←↙↓↘×]" <<< "$colours" || { screen; fail "no robot $unum of colour $team at $1"; }
    done
  done
  shows '●' || fail "no ball at $1"
}

# Plain text, both ports: the same picture.
for name in field monitor; do
  "$bin/simplemonitor" "127.0.0.1:$(port $name)" --once --size 100x36 > "$scratch/$name.txt" < /dev/null || fail "--once at the $name port"
  for team in L R; do
    for unum in 1 2 3 4 5 6 7 8 9 10 11; do grep -qE "$team$unum[→↗↑↖←↙↓↘]" "$scratch/$name.txt" || fail "no $team$unum at the $name port"; done
  done
  grep -q 'Plumb 0 : 0 Line   BeforeKickOff   0:00.0   half 1' "$scratch/$name.txt" || fail "no score at the $name port"
done
cmp <(head -35 "$scratch/field.txt") <(head -35 "$scratch/monitor.txt") || fail "the ports show different pictures"
"$bin/simplemonitor" "127.0.0.1:$(port field)" --once --ascii < /dev/null > "$scratch/ascii.txt"
if LC_ALL=C grep -q '[^ -~]' "$scratch/ascii.txt"; then fail "--ascii has other characters"; fi

# In a terminal: everything there, the game goes on, the window is made larger and smaller.
trainer() { node -e '
  const [port, text] = process.argv.slice(1), bytes = Buffer.alloc(4);
  bytes.writeUInt32BE(text.length);
  const socket = require("net").connect(Number(port), "127.0.0.1", () => { socket.write(bytes); socket.end(text); });
  socket.on("data", () => {}); socket.on("close", () => process.exit(0)); setTimeout(() => process.exit(0), 300);' "$(port monitor)" "$1"; }
for name in field monitor; do
  freshTerminal
  "${terminal[@]}" new-session -d -x 100 -y 36 "exec $bin/simplemonitor 127.0.0.1 --port $(port $name) --seconds 8 > $scratch/last-$name.txt 2>&1 > /dev/tty"
  waitFor shows 'Plumb 0 : 0 Line'
  expectRobots "the $name port"
  "${terminal[@]}" kill-server
done
freshTerminal
"${terminal[@]}" new-session -d -x 100 -y 36 "$bin/simplemonitor 127.0.0.1:$(port field); echo status \$? > $scratch/status"
waitFor shows 'BeforeKickOff'
trainer '(playMode PlayOn)(score (left 3)(right 2))(ball (pos 5 5 0.042)(vel 0 0 0))'
waitFor shows 'Plumb 3 : 2 Line   PlayOn   0:0[1-9]'
# 5 m are 100 / 31.7 * 5 = 15.8 columns and 7.9 rows from the middle.
[[ $(screen | sed -n 10,12p | grep -c "^ *.\{60,66\}●") == 1 ]] || { screen; fail "the ball is not at (5, 5)"; }
for size in "160 50" "80 24"; do
  read -r columns rows <<< "$size"
  "${terminal[@]}" resize-window -x "$columns" -y "$rows"
  waitFor shows "$(printf '^%*sPlumb 3 : 2 Line' $(((columns - 43) / 2)) '')"
  expectRobots "$columns x $rows"
done
"${terminal[@]}" resize-window -x 30 -y 10
waitFor shows 'too small'
"${terminal[@]}" send-keys q
waitFor test -s "$scratch/status"
expectEqual "$(cat "$scratch/status")" "status 0" "after q"

# What it costs while the game runs: at most 4 kB/s and 1 % of a core over the compact port.
freshTerminal
"${terminal[@]}" new-session -d -x 100 -y 36 "$bin/simplemonitor 127.0.0.1:$(port field) --seconds 6 > /dev/tty; sleep 60"
costs() { screen | grep -o '^simplemonitor: [0-9]* bytes/s for [0-9.]* s, [0-9.]* % of a core'; }
waitFor costs
read -r _ bytes _ _ _ _ cpu _ <<< "$(costs)"
echo "$(costs)"
((bytes > 300 && bytes <= 4000)) || fail "$bytes bytes a second"
awk "BEGIN { exit !($cpu < 1) }" || fail "$cpu % of a core"
"${terminal[@]}" kill-server

# The simulator goes and another comes: it says so and shows the new one. Ctrl-C ends it.
freshTerminal
"${terminal[@]}" new-session -d -x 100 -y 36 "$bin/simplemonitor 127.0.0.1:$(port field); echo status \$? > $scratch/status2"
waitFor shows 'PlayOn'
field=$(port field)
kill -TERM $simulator
wait $simulator || fail "the simulator ended with status $?"
waitFor shows 'trying again'
"$bin/simulator" --port 0 --monitor-port 0 --field-port "$field" --seed 1 > /dev/null 2>&1 &
waitFor shows 'left 0 : 0 right   BeforeKickOff'
"${terminal[@]}" send-keys C-c
waitFor test -s "$scratch/status2"

# Errors: one line, status 2.
expectError 2 "simplemonitor: cannot connect to 127.0.0.1:1: Connection refused; is a simulator running there?" "$bin/simplemonitor" 127.0.0.1:1 --once
expectError 2 "simplemonitor: --port: Value 70000 not in range 1 to 65535; see simplemonitor --help" "$bin/simplemonitor" --port 70000
expectError 2 "simplemonitor: localhost:x: a port, 1 to 65535, must follow the colon; see simplemonitor --help" "$bin/simplemonitor" localhost:x
expectError 2 "simplemonitor: --size 20x5: must be COLUMNSxROWS, from 40x12 to 1000x1000; see simplemonitor --help" "$bin/simplemonitor" --once --size 20x5
expectError 2 "simplemonitor: there is no option --fast; see simplemonitor --help" "$bin/simplemonitor" --fast
expectError 2 "simplemonitor: standard output is no terminal; --once prints one picture as text" "$bin/simplemonitor" "127.0.0.1:$field"
"$bin/simplemonitor" --help | grep -q 'bin/simplemonitor 192.168.1.20' || fail "--help has no examples"
