# Lines "type seed goal time falls" of an earlier state (the first file. A comment says which. It may be empty), of now with the kick
# made by hand, and of now: a table in Markdown, the figures as the project's JSON, and what is drawn. Variables: seeds, first, types, limit, json, drawn.
BEGIN { FS = "\t"; OFS = "\t"; kinds = split(types, type, " ") }
# An earlier state's comment: "# STATE, played on DAY, at most LIMIT s".
/^#/ { comment = substr($0, 3); next }
$2 < first || $2 >= first + seeds { next }
{
  state = FILENAME == ARGV[1] ? "before" : FILENAME == ARGV[2] ? "by_hand" : "now"
  add(state, $1)
  add(state, "all")
}
function add(state, t,   k) {
  k = ++n[state, t]
  goals[state, t] += $3; falls[state, t] += $5
  # Without a goal it would have taken longer than anything seen.
  time[state, t, k] = $3 ? $4 : 1e9
}
function sort(state, t,   i, j, v) {
  for (i = 2; i <= n[state, t]; ++i) {
    v = time[state, t, i]
    for (j = i; j > 1 && time[state, t, j - 1] > v; --j) time[state, t, j] = time[state, t, j - 1]
    time[state, t, j] = v
  }
}
# The lower rank of the median's interval: fewer than it are below the median with at most 2.5 %. 0: too few runs.
function lowerRank(m,   k, p, sum) {
  p = 0.5 ^ m
  for (k = 0; sum + p <= 0.025; ++k) { sum += p; p *= (m - k) / (k + 1) }
  return k
}
function middle(state, t,   m) { m = n[state, t]; return (time[state, t, int((m + 1) / 2)] + time[state, t, int(m / 2) + 1]) / 2 }
function atMost(v) { return v > limit ? limit : v }
function seconds(v) { return v >= 1e8 ? "over " limit : sprintf("%.1f", v) }
function row(state, t,   m, k, low, high, mid) {
  m = n[state, t]
  if (!m) return
  sort(state, t)
  mid = middle(state, t); k = lowerRank(m)
  low = k ? time[state, t, k] : 0; high = k ? time[state, t, m + 1 - k] : 0
  words = state; sub(/_/, " ", words)
  printf "| %s | %s | %d | %s | %s | %s | %s | %.2f |\n", t, words, m, seconds(mid), k ? seconds(low) " to " seconds(high) : "", \
    seconds(time[state, t, m]), interval(goals[state, t], m), falls[state, t] / m
  if (t != "all") printf "%s\t%d\t%g\t%g\t%g\n", words, place[t], atMost(mid), atMost(k ? low : mid), atMost(k ? high : mid) > drawn
  if (mid < 1e8) figure(state, t, "time_median", mid, "s", "lower")
  figure(state, t, "goals", 100 * goals[state, t] / m, "%", "higher")
  figure(state, t, "falls_per_run", falls[state, t] / m, "", "lower")
}
function figure(state, t, name, value, unit, better) {
  text = text (text == "" ? "" : ",\n") sprintf("  {\"name\": \"goal.%s%s.%s.%s\", \"value\": %.4g, \"unit\": \"%s\", \"better\": \"%s\"}", \
    (t == "all" ? "" : "type"), t, state, name, value, unit, better)
}
function ratios(state, words,   i) {
  if (!n[state, "all"]) return
  printf "\nMedian time %s, divided by that of now:", words
  for (i = 1; i <= kinds + 1; ++i) {
    if (!n[state, type[i]] || middle(state, type[i]) > 1e8) continue
    printf "%s %s %.2f", (i > 1 ? "," : ""), (type[i] == "all" ? "all" : "type " type[i]), middle(state, type[i]) / middle("now", type[i])
  }
  print "."
}
END {
  for (i = 1; i <= kinds; ++i) place[type[i]] = i - 1
  type[kinds + 1] = "all"
  print "## One robot alone until it scores\n"
  printf "What `make run` plays: embedded simulator, ball in the middle, kick-off, at most %d simulated seconds. %d seeds of each robot type, from %d on.", limit, seeds, first
  if (comment != "") {
    sub(/, at most .*/, "", comment)
    printf "\nBefore: the same seeds by an earlier state (%s), in its own simulator.\n", comment
  } else print ""
  print "By hand: the present state with `kickRight` as the only kick, which was designed by hand (`kickLong` and `kickShot`, found by"
  print "bin/optserver, are taken away). So the difference to now is what the kicks that were searched are worth."
  print "\nTime: game clock at the goal [s]; a run without a goal counts as longer than all others. The interval of the median is one of order"
  print "statistics (95 % at least, no assumption about the distribution), that of the share Wilson's.\n"
  print "| type | state | runs | median time | its 95 % interval | longest | with a goal | falls per run |\n|---|---|---|---|---|---|---|---|"
  for (i = 1; i <= kinds + 1; ++i) { row("before", type[i]); row("by_hand", type[i]); row("now", type[i]) }
  ratios("before", "before")
  ratios("by_hand", "with the kick made by hand")
  print "[\n" text "\n]" > json
}
