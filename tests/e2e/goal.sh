# A robot scores with three seeds, each within five simulated minutes.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
for seed in 1 2 3; do
  "$bin/game" --seed $seed --output "$scratch/$seed" > "$scratch/out" || fail "no goal with seed $seed: $(tail -1 "$scratch/out")"
  expectEqual "$(value "$scratch/$seed/summary.json" goal)" true "goal with seed $seed"
  awk "BEGIN { exit !($(value "$scratch/$seed/summary.json" goal_time_s) < 300) }" || fail "too late with seed $seed"
  for key in falls sim_time_s wall_s agent_cpu_us_per_cycle simulator_cpu_us_per_cycle; do
    [[ $(value "$scratch/$seed/summary.json" $key) =~ ^[0-9.]+$ ]] || fail "summary.json has no number $key"
  done
  # A line per second of the game, with time, places and what the robot does.
  lines=$(grep -cE '^ *[0-9]+ s  robot \( *-?[0-9.]+, *-?[0-9.]+\) +-?[0-9]+ deg  ball \( *-?[0-9.]+, *-?[0-9.]+\)  [A-Za-z_]+ ' "$scratch/out")
  seconds=$(value "$scratch/$seed/summary.json" goal_time_s)
  ((lines >= ${seconds%.*})) || fail "only $lines lines for the $seconds s of seed $seed"
done
