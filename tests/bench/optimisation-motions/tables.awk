# Lines "kind type motion figure mean error" (kind: hand or search), divided by tabs, and then doc/results/motion-server.md: tables
# 3.1 to 3.3 of the thesis in Markdown. Variables: types, tries, first, day, json.
BEGIN {
  # Thesis: type, time by hand and optimised [ms], success by hand and optimised [%], or distance [m] of the kick.
  addThesis("Front", "0 2660 620 80.6 86.4|1 2660 960 64.6 90.0|2 2660 720 65.2 91.6|3 2660 1060 65.6 93.7|4 2660 680 77.0 81.8")
  addThesis("Back", "0 2880 860 96.7 95.7|1 2880 680 78.3 84.5|2 2880 1100 94.5 88.9|3 2880 940 77.7 77.5|4 2880 1200 79.5 90.1")
  addThesis("Kick", "0 3500 500 3.2 12.1|1 3500 1300 3.8 11.2|2 3500 460 0.4 13.7|3 3500 1460 3.3 13.9|4 3500 1320 3.2 14.2")
  kinds = split(types, type, " ")
}
function addThesis(table, text,   rows, i, f) {
  split(text, rows, "|")
  for (i in rows) { split(rows[i], f, " "); handTime[table, f[1]] = f[2]; foundTime[table, f[1]] = f[3]; hand[table, f[1]] = f[4]; found[table, f[1]] = f[5] }
}
FNR == NR { split($0, f, "\t"); mean[f[1], f[2], f[3], f[4]] = f[5]; error[f[1], f[2], f[3], f[4]] = f[6]; next }
match($0, /motion-server\.type[0-9]\.[A-Za-z]+\.server\.[a-z]+/) {
  name = substr($0, RSTART, RLENGTH); split(name, p, "."); split($0, f, "|")
  server[substr(p[2], 5), p[3], p[5]] = f[3] + 0
}
function ms(kind, t, motion, name) { return sprintf("%.0f", mean[kind, t, motion, name]) }
function percent(kind, t, motion) { return sprintf("%.1f ± %.1f", 100 * mean[kind, t, motion, "up"], 100 * error[kind, t, motion, "up"]) }
function metres(kind, t, motion) { return sprintf("%.2f ± %.2f", mean[kind, t, motion, "distance"], error[kind, t, motion, "distance"]) }
function saved(before, now) { return before ? sprintf("%.0f %%", 100 * (1 - now / before)) : "" }
function onServer(t, motion, name, form) { return (t, motion, name) in server ? sprintf(form, server[t, motion, name]) : "" }
function figure(name, value, unit, better, peer) {
  text = text (text == "" ? "" : ",\n") sprintf("  {\"name\": \"optimisation-motions.%s\", \"value\": %.4g, \"unit\": \"%s\", \"better\": \"%s\", \"peer\": \"thesis\", \"peer_value\": %s}", name, value, unit, better, peer)
}
function tellMissing() { if (missing != "") print "\nNot measured in this run: type" missing "."; missing = "" }
function standUps(number, table, words,   i, t, h, s) {
  printf "\n### Table %s: standing up from the %s\n\n", number, words
  print "| type | by hand: time [ms] | upright [%] | optimised: time [ms] | upright [%] | shorter by | league's server: time [ms] | upright [%] | thesis, by hand | thesis, optimised | shorter by |"
  print "|---|---|---|---|---|---|---|---|---|---|---|"
  for (i = 1; i <= kinds; ++i) {
    t = type[i]; h = "standUp" table; s = h "Fast"
    if (!(("search", t, s, "time") in mean)) { missing = missing " " t; continue }
    printf "| %s | %s | %s | %s | %s | %s | %s | %s | %s ms, %s %% | %s ms, %s %% | %s |\n", t, ms("hand", t, h, "time"), percent("hand", t, h), \
      ms("search", t, s, "time"), percent("search", t, s), saved(mean["hand", t, h, "time"], mean["search", t, s, "time"]), \
      onServer(t, s, "time", "%.0f"), onServer(t, s, "upright", "%.0f"), handTime[table, t], hand[table, t], foundTime[table, t], found[table, t], \
      saved(handTime[table, t], foundTime[table, t])
    figure("type" t "." s ".time", mean["search", t, s, "time"], "ms", "lower", foundTime[table, t])
    figure("type" t "." s ".upright", 100 * mean["search", t, s, "up"], "%", "higher", found[table, t])
  }
  tellMissing()
}
END {
  print "## Tables 3.1 to 3.3 of the thesis\n"
  printf "Measured on %s, embedded simulator (ODE), %d tries of each motion, seeds from %d on, which no search had: mean and its standard error.\n", day, tries, first
  print "By hand: the motions of before the searches, in `config/motions`, `config/robots` or `tests/bench/optimisation-motions/by-hand`. They were designed by"
  print "hand and then improved a little by a first search, so they are shorter than the thesis's. Optimised: `standUpFrontFast`,"
  print "`standUpBackFast` and `kickLong` of each type, found by bin/optserver. Upright: within 30 degrees after two seconds of walking right after"
  print "the motion. Limbs that touch freeze, as on the league's server; the simulator in which types 0, 1 and 3 got their stand-ups from the back by"
  print "hand did not do that yet. The league's server: [motion-server](motion-server.md). Thesis: Seekircher 2015, SimSpark of that time."
  standUps("3.1", "Front", "front")
  standUps("3.2", "Back", "back")
  print "\n### Table 3.3: the kick\n"
  print "Time: of the whole motion. Contact: from its begin until the ball is touched. The ball lies anywhere in a square of 2 x 2 cm. Distance: forward,"
  print "until the ball rests. Off: mean deviation from the motion's own forward.\n"
  print "| type | by hand: time [ms] | contact [ms] | distance [m] | optimised: time [ms] | contact [ms] | distance [m] | off [deg] | upright [%] | farther by | league's server: distance [m] | thesis, by hand | thesis, optimised |"
  print "|---|---|---|---|---|---|---|---|---|---|---|---|---|"
  for (i = 1; i <= kinds; ++i) {
    t = type[i]; h = "kickRight"; s = "kickLong"
    if (!(("search", t, s, "time") in mean)) { missing = missing " " t; continue }
    printf "| %s | %s | %s | %s | %s | %s | %s | %.1f | %s | %.0f %% | %s | %s ms, %s m | %s ms, %s m |\n", t, ms("hand", t, h, "time"), ms("hand", t, h, "contact"), metres("hand", t, h), \
      ms("search", t, s, "time"), ms("search", t, s, "contact"), metres("search", t, s), mean["search", t, s, "off"], percent("search", t, s), \
      100 * (mean["search", t, s, "distance"] / mean["hand", t, h, "distance"] - 1), onServer(t, s, "distance", "%.2f"), \
      handTime["Kick", t], hand["Kick", t], foundTime["Kick", t], found["Kick", t]
    figure("type" t "." s ".time", mean["search", t, s, "time"], "ms", "lower", foundTime["Kick", t])
    figure("type" t "." s ".distance", mean["search", t, s, "distance"], "m", "higher", found["Kick", t])
  }
  tellMissing()
  print "[\n" text "\n]" > json
}
