# A robot scores with three seeds, each within five simulated minutes. The game of seed 3, which `make run` plays, is the one that
# README shows.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
for seed in 1 2 3; do
  "$bin/game" --seed $seed --output "$scratch/$seed" > "$scratch/$seed.out" || fail "no goal with seed $seed: $(tail -1 "$scratch/$seed.out")"
  expectEqual "$(value "$scratch/$seed/summary.json" goal)" true "goal with seed $seed"
  awk "BEGIN { exit !($(value "$scratch/$seed/summary.json" goal_time_s) < 300) }" || fail "too late with seed $seed"
  for key in falls sim_time_s wall_s agent_cpu_us_per_cycle simulator_cpu_us_per_cycle; do
    [[ $(value "$scratch/$seed/summary.json" $key) =~ ^[0-9.]+$ ]] || fail "summary.json has no number $key"
  done
  # A line per second of the game, with time, places and what the robot does.
  lines=$(grep -cE '^ *[0-9]+ s  robot \( *-?[0-9.]+, *-?[0-9.]+\) +-?[0-9]+ deg  ball \( *-?[0-9.]+, *-?[0-9.]+\)  [A-Za-z_]+ ' "$scratch/$seed.out")
  seconds=$(value "$scratch/$seed/summary.json" goal_time_s)
  ((lines >= ${seconds%.*})) || fail "only $lines lines for the $seconds s of seed $seed"
done

# README's picture of it, and the lines below the picture: the first two, the goal, and how long it took.
anew="make pictures ARGS=goal draws it anew"
cmp -s "$scratch/3/track.svg" doc/img/first-goal.svg || fail "doc/img/first-goal.svg is not the way of this game: $anew"
mapfile -t lines < "$scratch/3.out"
awk '/first-goal.svg/ { below = 1 } below && /^```$/ { exit } shown { print } below && /^```text$/ { shown = 1 }' README.md > "$scratch/shown"
printf '%s\n' "${lines[@]:0:2}" "  ..." "${lines[-2]}" "${lines[-1]%%;*}" > "$scratch/played"
diff "$scratch/shown" "$scratch/played" >&2 || fail "README shows (<) another game than this one (>): $anew"
