#!/usr/bin/env bash
# One robot from set starts: ball and robot anywhere in the other half, all robot types in turn. How often and when it scores
# within 60 s, and how many of its shots went beside or over the goal. Settings by the environment: TRIES [100], SEED of the first
# [1], BIN, the folder of programs [bin], CONFIG, the agent's configuration [config], OUT, what the results' files are called
# [build/bench/starts]. Writes OUT.json and OUT.md. `make bench-games` runs it with the games.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
source tests/support/set-start.bash
tries=${TRIES:-100} seed=${SEED:-1} bin=${BIN:-bin} config=${CONFIG:-config} out=${OUT:-build/bench/starts}
for value in "$tries" "$seed"; do
  [[ $value =~ ^[1-9][0-9]{0,5}$ ]] || { echo "starts.sh: '$value' is no whole number from 1 to 999999" >&2; exit 2; }
done
work=$PWD/build/bench/starts.work
mkdir -p "$(dirname "$out")" "$work"
rm -rf "$work/config"
cp -r "$config" "$work/config"
: > "$work/tries.tsv"
for ((i = 0; i < tries; ++i)); do
  # Places by lot, the same for the same seed: ball 1 to 13.5 m ahead, robot 0.5 to 3 m from it.
  read -r ballX ballY x y heading < <(awk -v seed=$((seed + i)) 'BEGIN {
    srand(seed); for (k = 0; k < 5; ++k) rand()
    bx = 1 + 12.5 * rand(); by = -7 + 14 * rand(); a = 6.2832 * rand(); d = 0.5 + 2.5 * rand()
    x = bx + d * cos(a); y = by + d * sin(a); if (x > 14) x = 28 - x
    printf "%.3f %.3f %.3f %.3f %.3f\n", bx, by, x, y, 6.2832 * rand() - 3.1416 }')
  type=$((i % 5))
  playSetStart "$type" $((seed + i)) 60 "$ballX $ballY $x $y" "-3 0 $heading"
  # A goal kick is a shot that missed.
  awk -F, -v type=$type -v ball="$ballX,$ballY" 'NR > 1 {
      if ($9 ~ /^goal_kick/ && mode !~ /^goal_kick/) ++missed
      if ($5 < 0.5 && !lies) { ++falls; lies = 1 } else if ($5 > 0.9) lies = 0
      mode = $9; time = $1 }
    END { printf "%d\t%s\t%d\t%.2f\t%d\t%d\n", type, ball, mode == "Goal_Left", time, missed, falls }' "$work/run/track.csv" >> "$work/tries.tsv"
  if ((i % 10 == 9)); then echo "$((i + 1)) of $tries starts"; fi
done
awk -F'\t' -v seed="$seed" -v json="$out.json" "$(< tests/support/interval.awk)"'
  function median(   i, j, v) { for (i = 2; i <= scored; ++i) { v = at[i]; for (j = i; j > 1 && at[j - 1] > v; --j) at[j] = at[j - 1]; at[j] = v }
    return scored ? at[int((scored + 1) / 2)] : 60 }
  { ++n; missed += $5; falls += $6; if ($3) { at[++scored] = $4; if ($5 == 0) ++first } }
  END {
    print "## One robot from set starts\n"
    printf "%d starts, seeds from %d: ball 1 to 13.5 m ahead in the other half, robot 0.5 to 3 m from it in any direction, types 0 to 4 in turn, at most 60 s. Shares have 95 %% intervals (Wilson).\n\n", n, seed
    print "| | |\n|---|---|"
    printf "| scored | %s |\n| scored with no ball over the line beside or over the goal | %s |\n", interval(scored, n), interval(first, n)
    printf "| balls into the goal, of all over that line | %s |\n| median time of a goal | %.1f s |\n| falls | %d |\n\n", interval(scored, scored + missed), median(), falls
    printf "[\n  {\"name\": \"games.starts.scored\", \"value\": %.4g, \"unit\": \"%%\", \"better\": \"higher\"},\n", 100 * scored / n > json
    printf "  {\"name\": \"games.starts.goal_time_median\", \"value\": %.4g, \"unit\": \"s\", \"better\": \"lower\"},\n", median() > json
    printf "  {\"name\": \"games.starts.in_goal_of_shots\", \"value\": %.4g, \"unit\": \"%%\", \"better\": \"higher\"}\n]\n", 100 * scored / (scored + missed) > json
  }' "$work/tries.tsv" > "$out.md"
cat "$out.md"
