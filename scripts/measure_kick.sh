#!/usr/bin/env bash
# What a kick does in games: the whole agent goes to the ball from random places, 1.5 m away and with any heading, and
# plays this kick. Prints distance and direction (medians), and scatter and spread (half of the range between the 16th and
# 84th percentile). The direction is the one with which the ball goes where the agent aims. It is the file's
# direction plus how far the ball went to the left of the goal: the robot's heading is a little off, too, when it kicks. Also the contact's time
# from the file, the mean height of the ball, the mean distance, and how many go less than half as far as the median. With
# --write they become the file's key `kick`.
#   scripts/measure_kick.sh TYPE MOTION [--write]
# Variables: TRIES [40], SEED of the first [20001], BIN, the folder of programs [bin], CONFIG [config].
# Examples:
#   scripts/measure_kick.sh 2 kickLong
#   TRIES=100 scripts/measure_kick.sh 0 kickRight --write
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source tests/support/set-start.bash
fail() { echo "measure_kick.sh: $*; see measure_kick.sh --help" >&2; exit 2; }
tries=${TRIES:-40} seed=${SEED:-20001} bin=${BIN:-bin} config=${CONFIG:-config}
(($# == 2 || $# == 3)) || fail "needs a type and a motion"
type=$1 motion=$2
[[ $type =~ ^[0-9]$ && -f $config/robots/simspark_type$type.json ]] || fail "no robot type '$type'"
[[ ${3-} == "" || ${3-} == --write ]] || fail "no option '$3'"
for value in "$tries" "$seed"; do
  [[ $value =~ ^[1-9][0-9]{0,5}$ ]] || fail "'$value' is no whole number from 1 to 999999"
done
file=$config/robots/simspark_type$type/motions/$motion.yaml
[[ -f $file ]] || file=$config/motions/$motion.yaml
direction=$(sed -n 's/^kick:.*direction: \(-\?[0-9.]*\).*/\1/p' "$file" 2> /dev/null) || true
contact=$(sed -n 's/^kick:.*contact: \([0-9.]*\).*/\1/p' "$file" 2> /dev/null) || true
grep -q '^kick:' "$file" 2> /dev/null || fail "type $type has no kick '$motion'"

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r "$config" "$work/config"
# The only kick that it has, and it does not dribble.
for other in "$work"/config/motions/*.yaml "$work/config/robots/simspark_type$type"/motions/*.yaml; do
  [[ $other == "$work/${file/#$config/config}" ]] || sed -i '/^kick:/d' "$other"
done
printf 'choice: {dribbleSpeed: 0.05}\n' > "$work/config/Striker2.yaml"
for ((i = 0; i < tries; ++i)); do
  read -r x y heading < <(awk -v seed=$((seed + i)) 'BEGIN {
    srand(seed); for (k = 0; k < 5; ++k) rand()
    a = 6.2832 * rand(); printf "%.3f %.3f %.3f\n", -6 + 1.5 * cos(a), 1.5 * sin(a), 6.2832 * rand() - 3.1416 }')
  playSetStart "$type" $((seed + i)) 30 "-6 0 $x $y" "$x $y $heading"
  # time,x,y,heading,up,ballX,ballY,ballZ,mode. The ball was met where it is faster than 1 m/s; the robot stood as it was `contact`
  # before. It has come to rest, or is reached again, by the time that the robot is half a metre from it.
  awk -F, -v contact="${contact:-0.2}" -v known="${direction:-0}" '
    NR == 1 || $9 == "BeforeKickOff" { next }
    { n = NR; at[n] = $1; x[n] = $2; y[n] = $3; h[n] = $4; d = sqrt(($6 - $2) ^ 2 + ($7 - $3) ^ 2) }
    t != "" && !kicked && $1 > t && sqrt(($6 - bx) ^ 2 + ($7 - by) ^ 2) / ($1 - t) > 1 {
      kicked = 1; x0 = bx; y0 = by; k = n; while (k > 2 && at[k - 1] != "" && at[k] > $1 - contact - 0.02) --k }
    kicked && $8 > top { top = $8 }
    kicked && (d > 1 || !away) { if (d > 1) away = 1; ex = $6; ey = $7 }
    kicked && away && d < 0.6 { exit }
    { t = $1; bx = $6; by = $7 }
    END { if (!kicked) exit
      side = -sin(h[k]) * (x0 - x[k]) + cos(h[k]) * (y0 - y[k]); way = sqrt((ex - x0) ^ 2 + (ey - y0) ^ 2)
      a = atan2(ey - y0, ex - x0) - atan2(0 - y0, 15 - x0); while (a > 3.14159265) a -= 6.2831853; while (a < -3.14159265) a += 6.2831853
      printf "%.3f %.2f %.3f\n", way, known + 57.29578 * (side > 0 ? -a : a), top }' "$work/run/track.csv" >> "$work/tries"
done
read -r kicked distance direction scatter spread rise mean short < <(awk '
  function quantile(v, share,   i, j, x, s) {
    for (i = 1; i <= n; ++i) s[i] = v[i]
    for (i = 2; i <= n; ++i) { x = s[i]; for (j = i; j > 1 && s[j - 1] > x; --j) s[j] = s[j - 1]; s[j] = x }
    return s[int(share * (n - 1) + 1.5)] }
  { ++n; way[n] = $1; off[n] = $2; height += $3 }
  END { if (n < 5) { print n + 0; exit }
    scatter = (quantile(off, 0.84) - quantile(off, 0.16)) / 2; spread = (quantile(way, 0.84) - quantile(way, 0.16)) / 2
    middle = quantile(way, 0.5)
    for (i = 1; i <= n; ++i) { sum += way[i]; short += way[i] < middle / 2 }
    printf "%d %.2f %.2f %.1f %.2f %.2f %.2f %.0f\n", n, middle, quantile(off, 0.5), (scatter > 1 ? scatter : 1),
      (spread > 0.1 ? spread : 0.1), (height / n > 0.06 ? height / n - 0.042 : 0), sum / n, 100 * short / n }' "$work/tries")
((kicked >= 5)) || { echo "measure_kick.sh: $kicked of $tries tries came to a kick" >&2; exit 1; }
line="kick: {distance: $distance, direction: $direction${contact:+, contact: $contact}, scatter: $scatter, spread: $spread, rise: $rise}"
echo "$line  # type $type, $motion: $kicked of $tries tries, seeds from $seed; mean $mean m, $short % go less than half as far as the median"
[[ ${3-} ]] || exit 0
sed "s/^kick:.*/$line/" "$file" > "$file.part"
mv "$file.part" "$file"
