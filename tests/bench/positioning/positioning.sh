#!/usr/bin/env bash
# Kick positioning (Seekircher 2015, 3.1.2). A robot 1.5 m from the ball, in any direction and with any heading, goes to
# the ball and kicks it towards a goal that is too far for a shot. How long until the ball moves, how far it goes, how
# far off. Settings by the environment: TRIES of each type [40], SEED of the first [6001], TYPES, BIN [bin], CONFIG, the
# agent's configuration [config], OUT [build/bench/positioning]. Writes OUT.json and OUT.md.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
source tests/support/set-start.bash
tries=${TRIES:-40} seed=${SEED:-6001} types=${TYPES:-0 1 2 3 4} bin=${BIN:-bin} config=${CONFIG:-config} out=${OUT:-build/bench/positioning}
for value in "$tries" "$seed"; do
  [[ $value =~ ^[1-9][0-9]{0,5}$ ]] || { echo "positioning.sh: '$value' is no whole number from 1 to 999999" >&2; exit 2; }
done
mkdir -p "$(dirname "$out")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r "$config" "$work/config"
for type in $types; do
  for ((i = 0; i < tries; ++i)); do
    # Places by lot, the same for the same seed. The ball lies in the own half: the farthest kick is the best one.
    read -r x y heading < <(awk -v seed=$((seed + i)) 'BEGIN {
      srand(seed); for (k = 0; k < 5; ++k) rand()
      a = 6.2832 * rand(); printf "%.3f %.3f %.3f\n", -6 + 1.5 * cos(a), 1.5 * sin(a), 6.2832 * rand() - 3.1416 }')
    # It beams itself there, so that it knows where it is.
    playSetStart "$type" $((seed + i)) 40 "-6 0 $x $y" "$x $y $heading"
    # Begins when the play is on. The kick is where the ball is faster than 1 m/s. It has come to rest, or is reached again, by
    # the time that the robot is half a metre from it.
    awk -F, -v type="$type" '
      NR == 1 || $9 == "BeforeKickOff" { next }
      start == "" { start = $1; t = $1; bx = $6; by = $7; x0 = bx; y0 = by; next }
      { dt = $1 - t; d = sqrt(($6 - $2) ^ 2 + ($7 - $3) ^ 2); v = dt > 0 ? sqrt(($6 - bx) ^ 2 + ($7 - by) ^ 2) / dt : 0 }
      kicked == "" && v > 1 { kicked = t - start; x0 = bx; y0 = by }
      kicked != "" && (d > 1 || !away) && $1 - start - kicked < 15 { if (d > 1) away = 1; ex = $6; ey = $7 }
      kicked != "" && away && d < 0.6 { exit }
      $5 < 0.5 && kicked == "" && !lies { ++falls; lies = 1 }
      { t = $1; bx = $6; by = $7 }
      END { if (kicked == "") print type "\t-\t0\t0\t" falls + 0
        else printf "%d\t%.2f\t%.2f\t%.1f\t%d\n", type, kicked, sqrt((ex - x0) ^ 2 + (ey - y0) ^ 2),
          atan2(ey - y0, ex - x0) * 57.2958 - atan2(0 - y0, 15 - x0) * 57.2958, falls }' "$work/run/track.csv" >> "$work/tries.tsv"
  done
  echo "type $type: $tries tries"
done
awk -F'\t' -v tries="$tries" -v seed="$seed" -v json="$out.json" '
  function quantile(values, n, share,   i, j, v) {
    for (i = 2; i <= n; ++i) { v = values[i]; for (j = i; j > 1 && values[j - 1] > v; --j) values[j] = values[j - 1]; values[j] = v }
    return n ? values[int(share * (n - 1) + 1.5)] : 0 }
  function add(name, value, unit, better) {
    printf "%s  {\"name\": \"positioning.type%s.%s\", \"value\": %.4g, \"unit\": \"%s\", \"better\": \"%s\"}", (figures++ ? ",\n" : "[\n"), type, name, value, unit, better > json }
  function finish(   i) {
    if (type == "") return
    a = quantile(time, n, 0.5); b = quantile(time, n, 0.95); c = quantile(way, n, 0.5); d = quantile(way, n, 0.05); e = quantile(off, n, 0.5)
    printf "| %s | %.1f | %.1f | %.2f | %.2f | %.1f | %d | %d |\n", type, a, b, c, d, e, tries - n, falls
    add("time_to_kick", a, "s", "lower"); add("time_to_kick_p95", b, "s", "lower"); add("distance", c, "m", "higher")
    add("distance_p5", d, "m", "higher"); add("off", e, "deg", "lower"); add("never", 100 * (tries - n) / tries, "%", "lower")
  }
  BEGIN {
    printf "%d tries of each type, seeds from %d: the robot 1.5 m from the ball in any direction, with any heading, in play; 21 m to the\n", tries, seed
    print "goal. Time: from the begin of the play to the moving ball; distance and direction: of where the ball lies when the robot is there\nagain. The thesis (figure 3.10, quick kick, robot type 0 of 2012) came from 5 s and 1.7 m to 4.7 s and 2.8 m.\n"
    print "| type | time to the kick, median [s] | 95 % [s] | distance, median [m] | 5 % [m] | off, median [deg] | never kicked | falls before |"
    print "|---|---|---|---|---|---|---|---|"
  }
  NR == 1 || $1 != type { finish(); type = $1 ""; n = falls = 0; split("", time); split("", way); split("", off) }
  { falls += $5; if ($2 != "-") { ++n; time[n] = $2; way[n] = $3; off[n] = $4 < 0 ? -$4 : $4 } }
  END { finish(); print "\n]" > json }' "$work/tries.tsv" > "$out.md"
cat "$out.md"
