# The track of a game and what its left players believed (OthersEvaluation). Each group of estimates has a line: what, belief, group,
# median and 95th percentile of the error in the field's frame [m], number of estimates of a player at a time. Groups:
# near, middle, far by the player's distance (3 and 8 m), all; of the ball also unseen, which the player has not seen for `unseen` [1] s.
BEGIN { FS = ","; OFS = "\t"; if (unseen == "") unseen = 1 }
FNR == 1 { ++files; next }
files == 1 { truth[sprintf("%.1f", $1), $2, $3] = $4 "," $5; next }
# The ball as the player alone knows it comes first in each of its moments, and says how long ago it was seen.
{ moment = FILENAME SUBSEP $1 }
$3 == "ball" && $2 == "alone" { age[moment] = $9 }
{
  side = $3 == "ball" ? "ball" : $3 == "mate" ? "left" : "right"
  key = sprintf("%.1f", $1) SUBSEP side SUBSEP $4
  if (!(key in truth)) next
  split(truth[key], p, ",")
  e = sqrt(($5 - p[1]) ^ 2 + ($6 - p[2]) ^ 2)
  add($3, $2, $8 < 3 ? "near" : $8 < 8 ? "middle" : "far", e)
  add($3, $2, "all", e)
  if ($3 == "ball" && (!(moment in age) || age[moment] > unseen)) add("ball", $2, "unseen", e)
  scenes[moment]
}
function add(what, belief, group, e,   g) {
  g = what SUBSEP belief SUBSEP group
  groups[g]
  ++count[g]
  error[g, count[g]] = e
}
# The value below which this share of a group's errors lies.
function quantile(share, m) { return sorted[int(1 + share * (m - 1) + 0.5)] }
function sort(m,   gap, i, j, value) {
  for (gap = int(m / 2); gap > 0; gap = int(gap / 2))
    for (i = gap + 1; i <= m; ++i) {
      value = sorted[i]
      for (j = i; j > gap && sorted[j - gap] > value; j -= gap) sorted[j] = sorted[j - gap]
      sorted[j] = value
    }
}
END {
  for (s in scenes) ++moments
  for (g in groups) {
    m = count[g]
    for (i = 1; i <= m; ++i) sorted[i] = error[g, i]
    sort(m)
    split(g, part, SUBSEP)
    print part[1], part[2], part[3], quantile(0.5, m), quantile(0.95, m), m / moments
  }
}
