#!/usr/bin/env bash
# Games against a team that is known by its start command only (OTHER of `make bench-games`): here our own agent, started as
# a stranger is, with host, port, name and number of players. The table and the figures name both teams.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
export PLUMBLINE_BIN=$bin
games=(env HALF=3 SEED=7 JOBS=1)
cat > "$scratch/start.sh" << END
#!/usr/bin/env bash
# HOST PORT TEAM NUMBER
echo "\$@" > "$scratch/started"
for ((i = 1; i <= \$4; ++i)); do
  "$bin/agent" --host "\$1" --port "\$2" --team "\$3" --number \$i --type 1 --config "$PWD/config" > /dev/null 2>&1 < /dev/null &
done
END
chmod +x "$scratch/start.sh"
"${games[@]}" GAMES=2 PLAYERS=1 OUT="$scratch/games" OTHER="$scratch/start.sh {host} {agent} {team} {players}" tests/bench/games/games.sh \
  > "$scratch/out" 2>&1 || fail "games: $(cat "$scratch/out")"
read -r host port team players < "$scratch/started"
expectEqual "$host $team $players" "127.0.0.1 Other 1" "what the other team got"
[[ $port =~ ^[0-9]+$ ]] || fail "its port: '$port'"
grep -q '^Games of 2 x 3 s, 1 against 1 on the embedded simulator, .*, seeds 7 to 8, played on [0-9-]*; ' "$scratch/games.md" || fail "table: $(cat "$scratch/games.md")"
grep -q '^| | Team | Other |$' "$scratch/games.md" || fail "columns: $(cat "$scratch/games.md")"
for row in "goals for" shots "possession \[%\]" falls "fouls: touching" charging "free kicks against"; do
  grep -q "^| $row | [0-9.]* ± [0-9.]* | [0-9.]* ± [0-9.]* |$" "$scratch/games.md" || fail "row $row: $(cat "$scratch/games.md")"
done
grep -q "^| players that ended before the game or with an error | 0.00 ± 0.00 | 0.00 ± 0.00 |$" "$scratch/games.md" || fail "ended players: $(cat "$scratch/games.md")"
grep -q "^| late cycles of a player (more than 20 ms of CPU) | 0.00 ± 0.00 | - |$" "$scratch/games.md" || fail "late cycles: $(cat "$scratch/games.md")"
grep -q "^| CPU of a player per cycle, mean \[us\] | [1-9][0-9.]* ± [0-9.]* | - |$" "$scratch/games.md" || fail "CPU: $(cat "$scratch/games.md")"
grep -q "^| goal difference | -*[0-9.]* ± [0-9.]* | -*[0-9.]* ± [0-9.]* |$" "$scratch/games.md" || fail "goal difference: $(cat "$scratch/games.md")"
for figure in team.goals team.shots other.possession other.falls; do
  grep -q "\"games.$figure\", \"value\": [0-9.]*, " "$scratch/games.json" || fail "figure $figure: $(cat "$scratch/games.json")"
done
cut -d, -f17 "$scratch/games/games.log" | grep -cx over | grep -qx 2 || fail "games.log: $(cat "$scratch/games/games.log")"

# Shots are those of games.log. A log without them, of before there were any, gives none.
shotsOf() { awk -v played="$scratch/games/played" -f tests/bench/games/tracks.awk "$1" | cut -f1,9 | sort -u | tr '\t\n' ' ,'; }
awk -F, -v OFS=, 'NR > 1 { for (i = 1; i <= NF; ++i) if (name[i] ~ /^shots_/) $i = (($3 == "Team") == (name[i] == "shots_left")) ? 7 : 4 }
  { if (NR == 1) split($0, name, ","); print }' "$scratch/games/games.log" > "$scratch/shots.log"
expectEqual "$(shotsOf "$scratch/shots.log")" "Other 4,Team 7," "shots of the table"
sed 's/,[^,]*,[^,]*$//' "$scratch/games/games.log" > "$scratch/old.log"
expectEqual "$(shotsOf "$scratch/old.log")" "Other -,Team -," "shots of an old log"

# How fast a player goes to a ball that rests: from the second second on, not while it lies, and not nearer than 1.5 m.
walk() { # a player's y by the time, and how upright it is from 3 s on
  echo "time,side,number,x,y,up,mode"
  for ((i = 0; i < 16; ++i)); do
    LC_ALL=C awk -v i=$i -v up="$1" 'BEGIN {
      y = 9 - (i < 3 ? 0.1 * i : 0.2 + 0.55 * (i - 2)); if (y < 2) y = 2
      printf "%.2f,ball,0,0.00,0.00,0,PlayOn\n%.2f,left,2,0.00,%.2f,%s,PlayOn\n", i / 2, i / 2, y, (i > 5 ? up : 1) }'
  done
}
fastest() { awk -v played="$scratch/walks" -f tests/bench/games/tracks.awk "$scratch/games/games.log" | cut -f22 | sed -n 1p; }
mkdir -p "$scratch/walks/1" "$scratch/walks/2"
walk 1 > "$scratch/walks/1/track.csv"
expectEqual "$(fastest)" "1.1" "speed on the way to the ball"
walk 0.2 > "$scratch/walks/1/track.csv"
expectEqual "$(fastest)" "1.1" "speed until it lies"
sed 's/PlayOn$/KickOff_Left/' "$scratch/walks/1/track.csv" > "$scratch/walks/2/track.csv"
mv "$scratch/walks/2/track.csv" "$scratch/walks/1/track.csv"
expectEqual "$(fastest)" "-" "speed before the kick-off"

# A player that ended before the game, and one that did not end: the table names both, with their exit status.
sed -i '1s/^\(left\|right\)\t1\t0\t0/\1\t1\t139\t1/' "$scratch/games/played/1/players.tsv"
sed -i '1s/^\(left\|right\)\t1\t0\t0/\1\t1\t-\t0/' "$scratch/games/played/2/players.tsv"
awk -v played="$scratch/games/played" -f tests/bench/games/tracks.awk "$scratch/games/games.log" > "$scratch/ended.tsv"
awk -v half=3 -v players=1 -v json="$scratch/ended.json" -f tests/support/interval.awk -f tests/bench/games/table.awk "$scratch/ended.tsv" > "$scratch/ended.md"
grep -qF "exit status: Team, seed 7: 1(139). Team, seed 8: 1(-)." "$scratch/ended.md" || fail "who ended: $(cat "$scratch/ended.md")"
grep -q "^| players that ended before the game or with an error | 1.00 ± 0.00 | 0.00 ± 0.00 |$" "$scratch/ended.md" || fail "ended players: $(cat "$scratch/ended.md")"

# One that was asked to end after the game is none of them, but one that was before is.
sed -i '1s/^\(left\|right\)\t1\t139\t1/\1\t1\t143\t0/' "$scratch/games/played/1/players.tsv"
sed -i '1s/^\(left\|right\)\t1\t-\t0/\1\t1\t143\t1/' "$scratch/games/played/2/players.tsv"
awk -v played="$scratch/games/played" -f tests/bench/games/tracks.awk "$scratch/games/games.log" > "$scratch/ended.tsv"
awk -v half=3 -v players=1 -v json="$scratch/ended.json" -f tests/support/interval.awk -f tests/bench/games/table.awk "$scratch/ended.tsv" > "$scratch/ended.md"
grep -qF "exit status: Team, seed 8: 1(143)." "$scratch/ended.md" || fail "who was stopped: $(cat "$scratch/ended.md")"

# A start script that knows nothing but the host is called in its folder; ours reads the port from the environment.
printf '#!/bin/sh\nexec "%s/agent" --team Plain --number 2 --host "$1" --config "%s" > /dev/null 2>&1\n' "$bin" "$PWD/config" > "$scratch/plain.sh"
chmod +x "$scratch/plain.sh"
"${games[@]}" GAMES=1 PLAYERS=1 OUT="$scratch/plain" OTHER_NAME="A plain team" OTHER="$scratch/plain.sh" tests/bench/games/games.sh > "$scratch/out" 2>&1 || fail "a plain script: $(cat "$scratch/out")"
expectEqual "$(tail -1 "$scratch/plain/games.log" | cut -d, -f3,4,17)" "Team,Other,over" "a game against a plain script"

# On the league's server: it is looked for, and the table and the figures name it.
env HALF=3 GAMES=1 PLAYERS=1 SERVER=rcssserver3d RCSSSERVER3D=no-such-server OUT="$scratch/league" OTHER="$scratch/plain.sh" tests/bench/games/games.sh > "$scratch/out" 2>&1 \
  && fail "a game without a server: $(cat "$scratch/out")"
grep -q 'startGame.sh: no no-such-server in PATH: install rcssserver3d or set RCSSSERVER3D to it$' "$scratch/out" || fail "without a server: $(cat "$scratch/out")"
awk -v half=3 -v players=1 -v other="A team" -v server=rcssserver3d -v json="$scratch/league.json" -f tests/support/interval.awk -f tests/bench/games/table.awk "$scratch/games/games.tsv" > "$scratch/league.md"
grep -q "^## The team against A team, on the league's server$" "$scratch/league.md" || fail "heading: $(cat "$scratch/league.md")"
grep -q "^Games of 2 x 3 s, 1 against 1 on the league's server (rcssserver3d), sides changed" "$scratch/league.md" || fail "table: $(cat "$scratch/league.md")"
grep -q '"games.a_team_1_rcssserver3d.team.goals", ' "$scratch/league.json" || fail "figures: $(cat "$scratch/league.json")"

# `make bench-games` names a server only if it is given one; it is another benchmark that has one of its own.
server() { make -n bench-games "$@" | grep -o 'SERVER=[^ ]*' || true; }
expectEqual "$(server)" "" "server of games without one"
expectEqual "$(server SERVER=rcssserver3d)" "SERVER=rcssserver3d" "server of games with one"

# In real time the table has the cycles that were late by the clock, too; a log of games in step has none.
! grep -q "by the clock" "$scratch/games.md" || fail "late by the clock in step: $(cat "$scratch/games.md")"
"${games[@]}" REALTIME=1 GAMES=1 PLAYERS=1 OUT="$scratch/paced" OTHER_NAME=Paced OTHER="$scratch/plain.sh" tests/bench/games/games.sh > "$scratch/out" 2>&1 || fail "real time: $(cat "$scratch/out")"
paced=$scratch/games-peers/Paced-1-realtime
grep -q "^## The team against Paced, in real time$" "$paced.md" || fail "heading: $(cat "$paced.md")"
grep -q '^Games of 2 x 3 s, 1 against 1 on the embedded simulator in real time, ' "$paced.md" || fail "table: $(cat "$paced.md")"
grep -q "^| late cycles of a player by the clock (answer more than 20 ms after the server's message) | [0-9.]* ± 0.00 | - |$" "$paced.md" || fail "late by the clock: $(cat "$paced.md")"
grep -q '"games.paced_1_realtime.team.late_cycles_wall", ' "$paced.json" || fail "figures: $(cat "$paced.json")"
rm "$paced".*

# Named teams are together in one page.
cp "$scratch/games-peers/A-plain-team-1.md" "$scratch/games-peers/Another-1.md"
cp "$scratch/games-peers/A-plain-team-1.json" "$scratch/games-peers/Another-1.json"
"${games[@]}" GAMES=1 PLAYERS=1 OUT="$scratch/plain2" OTHER_NAME="A plain team" OTHER="$scratch/plain.sh" tests/bench/games/games.sh > "$scratch/out" 2>&1 || fail "again: $(cat "$scratch/out")"
expectEqual "$(grep -c '^## The team against A plain team$' "$scratch/games-peers.md")" 2 "teams of the page"
expectEqual "$(grep -c '"games.a_plain_team_1.team.goals", ' "$scratch/games-peers.json")" 2 "figures of the page"
expectEqual "$(grep -c '},$' "$scratch/games-peers.json")" "$(($(grep -c '{' "$scratch/games-peers.json") - 1))" "commas between figures"

# A signal ends the games, and nothing is left.
env HALF=300 SEED=7 JOBS=1 GAMES=1 PLAYERS=1 OUT="$scratch/ended" OTHER="$scratch/plain.sh" tests/bench/games/games.sh > "$scratch/out" 2>&1 &
ended=$!
waitFor grep -qs "(Plain 2) plays" "$scratch/ended/played/1/server.log"
kill -TERM $ended
status=0
wait $ended || status=$?
expectEqual "$status" 143 "status of games that were ended"
! pgrep -f "$scratch/ended" > /dev/null || fail "left: $(pgrep -af "$scratch/ended")"

# What is wrong is said before anything starts.
expectError 2 "games.sh: OTHER: no start script /nowhere/start.sh" "${games[@]}" OTHER=/nowhere/start.sh OUT="$scratch/no" tests/bench/games/games.sh
expectError 2 "games.sh: PLAYERS='12' is not 1 to 11" "${games[@]}" OTHER=/nowhere PLAYERS=12 tests/bench/games/games.sh
expectError 2 "games.sh: PLAYERS needs OTHER, the command that starts the other team" "${games[@]}" PLAYERS=4 tests/bench/games/games.sh
expectError 2 "games.sh: OUT=$scratch/games exists already" "${games[@]}" OTHER="$scratch/plain.sh" OUT="$scratch/games" tests/bench/games/games.sh
expectError 2 "games.sh: SERVER='league' is neither simulator nor rcssserver3d" "${games[@]}" OTHER=/nowhere SERVER=league tests/bench/games/games.sh
expectError 2 "games.sh: SERVER needs OTHER, the command that starts the other team" "${games[@]}" SERVER=rcssserver3d tests/bench/games/games.sh
