# Lines "subject motion world figure mean error" (motion: start, without-SEED or with-SEED): a table of each subject in Markdown.
# Variables: about (of each subject a line), seeds, tries, first, json, draws (of a search).
BEGIN {
  worlds = split("nominal bullet drawn", world, " "); split("nominal|Bullet|drawn robots", title, "|")
  split(about, lines, "\n"); for (i in lines) { at = index(lines[i], "|"); text[substr(lines[i], 1, at - 1)] = substr(lines[i], at + 1) }
  names["standUp"] = "up time"; units["standUp"] = "upright [%]|time [ms]"
  names["kick"] = "distance off up"; units["kick"] = "distance [m]|off [deg]|upright [%]"
  split("up time distance off", all, " "); unit["up"] = "%"; unit["time"] = "ms"; unit["distance"] = "m"; unit["off"] = "deg"
  form["up"] = form["off"] = "%.1f"; form["time"] = "%.0f"; form["distance"] = "%.2f"
  better["up"] = better["distance"] = "higher"; better["time"] = better["off"] = better["cost"] = "lower"
}
{
  if (!($1 in seen)) { seen[$1] = 1; subject[++subjects] = $1 }
  if (!(($1, $2) in row)) { row[$1, $2] = 1; motions[$1] = motions[$1] " " $2 }
  scale = $4 == "up" ? 100 : 1
  value[$1, $2, $3, $4] = scale * $5; error[$1, $2, $3, $4] = scale * $6
}
function figure(name, number, unit, better) {
  list = list (list == "" ? "" : ",\n") sprintf("  {\"name\": \"robust.%s\", \"value\": %.4g, \"unit\": \"%s\", \"better\": \"%s\"}", name, number, unit, better)
}
function line(s, motion, label,   w, i, n, f) {
  n = split(names[s], f, " ")
  printf "| %s |", label
  for (w = 1; w <= worlds; ++w) {
    for (i = 1; i <= n; ++i) printf " " form[f[i]] " |", value[s, motion, world[w], f[i]]
    printf " %.1f |", value[s, motion, world[w], "cost"]
  }
  for (w = 2; w <= worlds; ++w) printf " %.1f |", value[s, motion, world[w], "cost"] - value[s, motion, "nominal", "cost"]
  print ""
}
# The mean of the motions that were found with or without draws, as a motion "mean-HOW".
function average(s, how,   n, m, i, w, j, f, k) {
  n = split(motions[s], m, " "); k = split(names[s] " cost", f, " "); found = 0
  for (i = 1; i <= n; ++i) if (index(m[i], how "-") == 1) ++found
  for (w = 1; w <= worlds; ++w) for (j = 1; j <= k; ++j) for (i = 1; i <= n; ++i)
    if (index(m[i], how "-") == 1) value[s, "mean-" how, world[w], f[j]] += value[s, m[i], world[w], f[j]] / found
}
function pairs(s, where,   n, m, i, less, all) {
  n = split(motions[s], m, " ")
  for (i = 1; i <= n; ++i) if (index(m[i], "with-") == 1) {
    ++all; less += value[s, m[i], where, "cost"] < value[s, "without-" substr(m[i], 6), where, "cost"]
  }
  return (less + 0) " of " all
}
function comparison(s, where,   gain) {
  gain = value[s, "mean-without", where, "cost"] - value[s, "mean-with", where, "cost"]
  return sprintf("%.1f %s (%s pairs less)", gain < 0 ? -gain : gain, gain > 0 ? "less" : "more", pairs(s, where))
}
END {
  print "The same searches from a motion that was there before (start), seeds " seeds ", once in the nominal world alone and once"
  print "with draws: over " draws " worlds, of which " (draws - 1) " have effects of `config/optimisation/unlike.yaml` (masses, centres of mass, delay, friction, motors,"
  print "offsets), each with a chance of one half. Both see as many runs. Then " tries " tries of each, seeds from " first " on, in the nominal world, on"
  print "Bullet, which no search saw, and on 40 drawn robots that no search had (draws 1000 to 1039). Upright: within 30 degrees two seconds after"
  print "the motion. Cost: what the search minimises. Lost: compared with the nominal world. The standard error of a share is at most " sprintf("%.1f", 50 / sqrt(tries)) " %."
  for (k = 1; k <= subjects; ++k) {
    s = subject[k]
    print "\n## " text[s] "\n"
    n = split(units[s], u, "|")
    line1 = "| motion |"; line2 = "|---|"
    for (w = 1; w <= worlds; ++w) {
      for (i = 1; i <= n; ++i) { line1 = line1 (i == 1 ? " " title[w] ": " : " ") u[i] " |"; line2 = line2 "---|" }
      line1 = line1 " cost |"; line2 = line2 "---|"
    }
    print line1 " cost lost on Bullet | on drawn robots |\n" line2 "---|---|"
    line(s, "start", "start")
    count = split(motions[s], m, " ")
    for (i = 2; i <= count; ++i) { label = m[i]; sub(/-/, " draws, seed ", label); line(s, m[i], label) }
    for (h = 1; h <= 2; ++h) {
      how = h == 1 ? "without" : "with"
      average(s, how)
      line(s, "mean-" how, "**" how " draws, mean**")
    }
    print "\nThe cost of what is found with draws is, in the mean of the seeds: nominal " comparison(s, "nominal") ", on Bullet " comparison(s, "bullet") ", on drawn robots " comparison(s, "drawn") "."
    for (h = 0; h <= 2; ++h) for (w = 1; w <= worlds; ++w) {
      how = h == 0 ? "start" : h == 1 ? "mean-without" : "mean-with"
      of = s "." (h == 0 ? "start" : h == 1 ? "without_draws" : "with_draws") "." world[w] "."
      n = split(names[s] " cost", f, " ")
      for (i = 1; i <= n; ++i) figure(of (f[i] == "up" ? "upright" : f[i]), value[s, how, world[w], f[i]], unit[f[i]], better[f[i]])
    }
  }
  print "[\n" list "\n]" > json
}
