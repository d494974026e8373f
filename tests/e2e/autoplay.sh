# Games without a person: tiny ones from kick-off to their end, one that hangs, one whose server dies, several at once,
# an interruption that leaves nothing behind, and the averages.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
export PLUMBLINE_BIN=$bin
auto=scripts/autoplay
log=$scratch/games.log
# The team's scripts start the agent beside them.
mkdir "$scratch/bin"
cp bin/start.sh bin/kill.sh "$scratch/bin"
ln -s "$bin/agent" "$scratch/bin/agent"
start="$scratch/bin/start.sh {host} --config $PWD/config --players"
left() { pgrep -f "$scratch" > /dev/null; }
# 600 looks are a minute and more: a machine with nothing else to do needs a few, and no process is given more than 30 s to end.
nothingLeft() { local i; for ((i = 0; i < 600; ++i)); do left || return 0; sleep 0.1; done; pgrep -af "$scratch" >&2; fail "left behind after $1"; }
column() { awk -F, -v name="$2" 'NR == 1 { for (i = 1; i <= NF; ++i) if ($i == name) c = i } END { print $c }' "$1"; } # of the last game

# A whole game, and the same again by its seed. What happened in it comes from the scene.
for run in 1 2; do
  "$auto/startGame.sh" --half-time 15 --players 6 --seed 5 --names Red,Blue --log "$log" --output "$scratch/game$run" \
    "$start 3" "$start 3" > "$scratch/out" 2>&1 || fail "game $run: $(cat "$scratch/out")"
  nothingLeft "a game"
done
expectEqual "$(head -1 "$log")" \
  "date,server,left,right,seed,half_time_s,score_left,score_right,falls_left,falls_right,kicks_left,kicks_right,players_left,players_right,game_s,wall_s,end,touching_left,touching_right,charging_left,charging_right,illegal_defence_left,illegal_defence_right,free_kicks_against_left,free_kicks_against_right,passes_left,passes_right,passes_completed_left,passes_completed_right,shots_left,shots_right" "header"
expectEqual "$(wc -l < "$log")" 3 "lines of games.log"
for pair in server=simulator left=Red right=Blue seed=5 half_time_s=15 players_left=3 players_right=3 end=over; do
  expectEqual "$(column "$log" "${pair%%=*}")" "${pair#*=}" "column ${pair%%=*}"
done
awk "BEGIN { exit !($(column "$log" game_s) >= 30 && $(column "$log" game_s) < 31) }" || fail "length of the game: $(column "$log" game_s) s"
happened=$(($(column "$log" falls_left) + $(column "$log" falls_right) + $(column "$log" kicks_left) + $(column "$log" kicks_right) + $(column "$log" score_left) + $(column "$log" score_right)))
((happened > 0)) || fail "neither a kick nor a fall in 30 s of two teams of three"
for side in left right; do
  goals=$(column "$log" score_$side) shots=$(column "$log" shots_$side)
  [[ $shots =~ ^[0-9]+$ ]] && ((shots >= goals)) || fail "$side: $goals goals of '$shots' shots"
done
expectEqual "$(sed -n 2p "$log" | cut -d, -f5-15)" "$(sed -n 3p "$log" | cut -d, -f5-15)" "the same seed again"
cmp "$scratch/game1/track.csv" "$scratch/game2/track.csv" || fail "the same seed plays another game"

# Several at once, against a list, on both sides; a start script that knows nothing but the host.
rm "$log"
mkdir "$scratch/other"
printf '#!/bin/sh\n"%s" --team Other --number 3 --type 3 --host "$1" --config %s > /dev/null 2>&1 &\n' "$scratch/bin/agent" "$PWD/config" > "$scratch/other/start.sh"
chmod +x "$scratch/other/start.sh"
printf '# two opponents\nMirror %s 1\n\nOther %s\n' "$start" "$scratch/other/start.sh" > "$scratch/list"
"$auto/runOppList.sh" --games 2 --jobs 2 --half-time 3 --players 2 --log "$log" --output "$scratch/many" "$start 1" "$scratch/list" \
  > "$scratch/out" 2>&1 || fail "runOppList: $(cat "$scratch/out")"
nothingLeft "a list of games"
expectEqual "$(cut -d, -f3,4,5,17 "$log" | sort | tr '\n' ' ')" \
  "Mirror,Plumbline,3,over Other,Plumbline,4,over Plumbline,Mirror,1,over Plumbline,Other,2,over left,right,seed,end " "games of the list"
(($(grep -c '^\[[1-4]/4\] .* to go$' "$scratch/out") == 4)) || fail "progress: $(cat "$scratch/out")"

# Nobody comes; the server dies: the log says so, nothing stays.
status=0
"$auto/startGame.sh" --half-time 3 --players 2 --hang 2 --log "$log" --output "$scratch/hang" "true {host}" "true {host}" > "$scratch/out" 2>&1 || status=$?
expectEqual "$status" 1 "status of a game that hangs"
expectEqual "$(column "$log" end)" "hangs" "a game that hangs"
nothingLeft "a game that hangs"
"$auto/startGame.sh" --half-time 1000 --realtime --players 2 --log "$log" --output "$scratch/dies" "$start 1" "$start 1 --team Two" > "$scratch/out" 2>&1 &
game=$!
waitFor grep -q PlayOn "$scratch/dies/game.log"
kill -9 "$(pgrep -f "^[^ ]*bin/simulator .*$scratch/dies")"
status=0; wait $game || status=$?
expectEqual "$status" 1 "status of a game whose server dies"
expectEqual "$(column "$log" end)" "server gone" "a game whose server dies"
nothingLeft "a game whose server dies"

# An interruption ends all games and their agents.
"$auto/runOppList.sh" --games 2 --jobs 2 --half-time 1000 --realtime --players 2 --log "$scratch/none.log" --output "$scratch/stop" "$start 1" "$scratch/list" \
  > "$scratch/out" 2>&1 &
games=$!
waitFor grep -q PlayOn "$scratch/stop/1/game.log"
kill -TERM $games
status=0; wait $games || status=$?
expectEqual "$status" 130 "status after an interruption"
nothingLeft "an interruption"
[[ ! -e $scratch/none.log ]] || fail "an interrupted game is in the log"

# start.sh and kill.sh by themselves: the right team ends, the other stays.
"$bin/simulator" --port 0 --monitor-port 0 --ports-file "$scratch/ports.json" > "$scratch/simulator.log" 2>&1 &
waitFor test -s "$scratch/ports.json"
read -r agentPort monitorPort _ < <(tr -cs '0-9\n' ' ' < "$scratch/ports.json")
for team in One Two; do
  "$scratch/bin/start.sh" -p "$agentPort" -m "$monitorPort" -t $team -n 2 --config "$PWD/config" -- --stats "$scratch/$team{number}.json"
done
waitFor grep -q 'Two 2) plays' "$scratch/simulator.log"
count() { pgrep -fa "team $1 " | grep -o "number [0-9]*" | sort -u | wc -l; } # an agent is more than one process
expectEqual "$(count One) $(count Two)" "2 2" "agents"
"$scratch/bin/kill.sh" One
expectEqual "$(count One) $(count Two)" "0 2" "agents after kill.sh One"
"$scratch/bin/kill.sh"
expectEqual "$(count One) $(count Two)" "0 0" "agents after kill.sh"
expectEqual "$(cd "$scratch" && echo One[0-9].json Two[0-9].json)" "One1.json One2.json Two1.json Two2.json" "files by the players' numbers"

# The averages, against numbers worked out by hand.
cat > "$scratch/known.log" << 'END'
date,server,left,right,seed,half_time_s,score_left,score_right,falls_left,falls_right,kicks_left,kicks_right,players_left,players_right,game_s,wall_s,end
d,simulator,Us,A,1,300,2,0,3,4,10,20,11,11,600,1,over
d,simulator,A,Us,2,300,1,1,5,6,11,21,11,11,600,1,over
d,simulator,Us,A,3,300,0,1,7,8,12,22,11,11,600,1,over
d,simulator,Us,B,4,300,4,0,9,1,13,23,11,11,600,1,over
d,simulator,B,Us,5,300,9,0,9,9,9,9,11,11,10,1,server gone
END
squeeze() { tr -s ' ' | sed 's/ $//'; }
expectEqual "$("$auto/getAvgForEachOpp.sh" "$scratch/known.log" | squeeze)" "Us against ..., mean of a game and 95 % confidence
opponent games won drawn lost goals goals against difference falls falls other kicks kicks other
A 3 1 1 1 1.00 ± 2.48 0.67 ± 1.43 0.33 ± 3.79 5.33 ± 5.17 5.67 ± 5.17 14.33 ±14.56 17.67 ±14.56
B 1 1 0 0 4.00 0.00 4.00 9.00 1.00 13.00 23.00
all 4 2 1 1 1.75 ± 2.72 0.50 ± 0.92 1.25 ± 3.53 6.25 ± 3.98 4.50 ± 4.59 14.00 ± 7.69 19.00 ± 8.71
1 not counted: server gone" "averages for each opponent"
expectEqual "$("$auto/getAvgSteps.sh" --step 2 --team A "$scratch/known.log" | squeeze | sed -n '3,4p')" "games 1 to 2 2 0 1 1 0.50 ± 6.35 1.50 ± 6.35 -1.00 ±12.71 4.50 ± 6.35 4.50 ±19.06 15.50 ±57.18 15.50 ±69.88
games 3 to 3 1 1 0 0 1.00 0.00 1.00 8.00 7.00 22.00 12.00" "averages of steps"

# Bad input: one line, status 2.
expectError 2 "startGame.sh: two teams are wanted, not 1; see startGame.sh --help" "$auto/startGame.sh" bin/start.sh
expectError 2 "startGame.sh: no start script nowhere/start.sh; see startGame.sh --help" "$auto/startGame.sh" bin/start.sh nowhere/start.sh
expectError 2 "startGame.sh: unknown option --fast; see startGame.sh --help" "$auto/startGame.sh" --fast
expectError 2 "startGame.sh: --seed 'x' is no whole number from 1" "$auto/startGame.sh" --seed x bin/start.sh bin/start.sh
expectError 2 "startGame.sh: no server 'gazebo': simulator, rcssserver3d or a command with {agent} and {monitor}" "$auto/startGame.sh" --output "$scratch/bad" --server gazebo bin/start.sh bin/start.sh
expectError 2 "startGame.sh: no rcssserver3d in PATH: install rcssserver3d or set RCSSSERVER3D to it" env PATH=/usr/bin:/bin "$auto/startGame.sh" --output "$scratch/bad" --server rcssserver3d bin/start.sh bin/start.sh
printf 'One\n' > "$scratch/list"
expectError 2 "runOppList.sh: $scratch/list:1: NAME COMMAND is wanted, there is only 'One'" "$auto/runOppList.sh" bin/start.sh "$scratch/list"
expectError 2 "getAvgForEachOpp.sh: cannot read nowhere.log" "$auto/getAvgForEachOpp.sh" nowhere.log
printf '1,2\n' > "$scratch/bad.log"
expectError 2 "getAvgSteps.sh: $scratch/bad.log:1: no header; is this a games.log?" "$auto/getAvgSteps.sh" "$scratch/bad.log"
expectError 2 "start.sh: there is no robot type '5' in $PWD/config/robots; see start.sh --help" bin/start.sh --types 5 -n 1
expectError 2 "watchgame: --players: Value 23 not in range 0 to 22; see watchgame --help" "$bin/watchgame" --players 23
