# A team of four on the embedded simulator: one of them goes to the ball, the goalie stays in its goal, the others take places.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
"$bin/simulator" --port 0 --monitor-port 0 --ports-file "$scratch/ports.json" --sync --wait-agents 4 --kickoff-after 3 --seed 3 \
  --max-seconds 15 --die-with-parent > "$scratch/simulator.log" 2>&1 &
simulator=$!
waitFor test -s "$scratch/ports.json"
read -r agentPort monitorPort _ < <(tr -cs '0-9\n' ' ' < "$scratch/ports.json")
for number in 1 2 3 4; do
  "$bin/agent" --team Four --number $number --port "$agentPort" --monitor-port "$monitorPort" --status --crash-log "$scratch/crash$number" \
    > "$scratch/agent$number.log" 2>&1 &
  agents[number]=$!
  waitFor grep -q "." "$scratch/agent$number.log"
done
wait $simulator || fail "the simulator: $(tail -1 "$scratch/simulator.log")"
kill -TERM "${agents[@]}" 2> /dev/null || true
wait

# status TIME robot X Y HEADING ball X Y WORDS; the clock runs from the kick-off on.
at() { awk '$1 == "status" && $2 >= 1 { print FILENAME, $0 }' "$scratch"/agent?.log; }
at | awk '
  /going to kick|kicking|dribbling/ { ++atBall[$3] }
  { seconds[$3] }
  END {
    for (second in seconds) { ++all; one += atBall[second] == 1 }
    print one " of " all " seconds with one player at the ball"
    exit !(all >= 8 && one >= 0.8 * all)
  }' > "$scratch/striker" || fail "$(cat "$scratch/striker")"
at | awk '/agent1/ && ($5 > -12 || $6 ^ 2 > 9) { print; bad = 1 } END { exit bad }' > "$scratch/goalie" ||
  fail "the goalie left its goal: $(tail -1 "$scratch/goalie")"
at | awk '
  { x[$3, $1] = $5; y[$3, $1] = $6; seconds[$3]; player[$1] }
  END {
    for (s in seconds) for (a in player) for (b in player)
      if (a < b && (s, a) in x && (s, b) in x && (x[s, a] - x[s, b]) ^ 2 + (y[s, a] - y[s, b]) ^ 2 < 0.09) { print s, a, b; bad = 1 }
    exit bad
  }' > "$scratch/close" || fail "two of a team stand in each other: $(head -1 "$scratch/close")"
cat "$scratch/striker"
