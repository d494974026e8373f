# From the lines of errors.awk of several games: a table in Markdown with means over the games and 95 % intervals, and the figures
# as the project's JSON. Variables: half, games, seed, players, json.
BEGIN { FS = "\t" }
{
  g = $1 SUBSEP $2 SUBSEP $3
  ++n[g]
  for (i = 4; i <= 6; ++i) { sum[g, i] += $i; squares[g, i] += $i ^ 2 }
}
function mean(g, i) { return sum[g, i] / n[g] }
function cell(g) {
  if (!n[g]) return " - |"
  return sprintf(" %.2f ± %.2f, %.2f ± %.2f |", mean(g, 4), half95(sum[g, 4], squares[g, 4], n[g]), mean(g, 5), half95(sum[g, 5], squares[g, 5], n[g]))
}
END {
  if (!NR) { print "no estimates" > "/dev/stderr"; exit 1 }
  split("near middle far all unseen", group, " ")
  printf "%d games of 2 x %s s, %d against %d on the embedded simulator, seeds from %s. The estimates of the left team's players are compared twice a second with the monitor's scene. ", games, half, players, players, seed
  print "Each cell has the median and the 95th percentile of the error in the field's frame [m], as means of the games with their 95 % intervals. The error of the player's own pose is included. Alone: only what the player sees, tracked; team: with messages of team mates. Unseen: moments in which the player has not seen the ball for more than 1 s. Known: estimates of a player at a time.\n"
  print "| | | nearer than 3 m | 3 to 8 m | farther | all | ball unseen | known | unseen, share of moments |\n|---|---|---|---|---|---|---|---|---|"
  text = "["
  for (w = 1; w <= 3; ++w) for (b = 1; b <= 2; ++b) {
    what = w == 1 ? "ball" : w == 2 ? "mate" : "opponent"; belief = b == 1 ? "alone" : "team"
    printf "| %s | %s |", what, belief
    for (k = 1; k <= 5; ++k) printf "%s", (k == 5 && w > 1 ? " |" : cell(what SUBSEP belief SUBSEP group[k]))
    all = what SUBSEP belief SUBSEP "all"; unseen = what SUBSEP belief SUBSEP "unseen"
    printf " %.1f |", n[all] ? mean(all, 6) : 0
    if (w == 1 && n[all]) printf " %.1f %% |\n", 100 * sum[unseen, 6] / n[all]; else print " |"
    for (k = 1; k <= 5; ++k) {
      g = what SUBSEP belief SUBSEP group[k]
      if (n[g]) text = text sprintf("%s\n  {\"name\": \"beliefs.%s.%s.%s\", \"value\": %.4g, \"unit\": \"m\", \"better\": \"lower\"}", (text == "[" ? "" : ","), what, belief, group[k], mean(g, 4))
    }
  }
  print ""
  print text "\n]" > json
}
