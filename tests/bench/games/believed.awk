# The track of a game and what its left players believed (OthersEvaluation): errors by distance, alone and with mates' words.
BEGIN { FS = "," }
FNR == 1 { ++files; next }
files == 1 { truth[sprintf("%.1f", $1), $2, $3] = $4 "," $5; next }
{
  side = $3 == "ball" ? "ball" : $3 == "mate" ? "left" : "right"
  key = sprintf("%.1f", $1) SUBSEP side SUBSEP $4
  if (!(key in truth)) next
  split(truth[key], p, ",")
  bin = $8 < 3 ? 1 : $8 < 8 ? 2 : 3
  group = $3 SUBSEP $2 SUBSEP bin
  ++count[group]
  error[group, count[group]] = sqrt(($5 - p[1]) ^ 2 + ($6 - p[2]) ^ 2)
  ++scenes[FILENAME, $1]
}
# The value below which this share of a group's errors lies.
function quantile(group, share,   i, m, sorted) {
  m = count[group]
  for (i = 1; i <= m; ++i) sorted[i] = error[group, i]
  asortOf(sorted, m)
  return sorted[int(1 + share * (m - 1) + 0.5)]
}
function asortOf(a, m,   gap, i, j, value) {
  for (gap = int(m / 2); gap > 0; gap = int(gap / 2))
    for (i = gap + 1; i <= m; ++i) {
      value = a[i]
      for (j = i; j > gap && a[j - gap] > value; j -= gap) a[j] = a[j - gap]
      a[j] = value
    }
}
END {
  players = 0
  print "## What players believe of ball and others\n"
  print "One game of 2 x 60 s. The estimates of all eleven players are compared twice a second with the monitor's scene. The table shows median and 95th percentile of the error in the field's frame [m] by distance, and the number of estimates of a player at a time. The error of the player's own pose is included. Alone: only what the player sees, tracked; team: with messages of team mates.\n"
  print "| | | nearer than 3 m | 3 to 8 m | farther | |\n|---|---|---|---|---|---|"
  for (s in scenes) ++players
  for (w = 1; w <= 3; ++w) for (b = 1; b <= 2; ++b) {
    what = w == 1 ? "ball" : w == 2 ? "mate" : "opponent"; belief = b == 1 ? "alone" : "team"
    printf "| %s | %s |", what, belief
    all = 0
    for (bin = 1; bin <= 3; ++bin) {
      g = what SUBSEP belief SUBSEP bin
      all += count[g]
      if (count[g]) printf " %.2f, %.2f |", quantile(g, 0.5), quantile(g, 0.95); else printf " |"
    }
    printf " %.1f known |\n", all / players
  }
  print ""
}
