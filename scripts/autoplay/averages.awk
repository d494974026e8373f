# Averages over the lines of games.log with 95 % confidence intervals (Student's t). Variables: team (ours; empty:
# the one in all games), step (0: a row for each opponent, else a row for each so many games in their order).
BEGIN {
  FS = ","
  split("12.706 4.303 3.182 2.776 2.571 2.447 2.365 2.306 2.262 2.228 2.201 2.179 2.160 2.145 2.131 2.120 2.110 2.101 2.093 " \
    "2.086 2.080 2.074 2.069 2.064 2.060 2.056 2.052 2.048 2.045 2.042", quantile, " ")
  split("for against difference falls falls_other kicks kicks_other", measures, " ")
}
function fail(what) { print what > "/dev/stderr"; failed = 1; exit 2 }
function place() { return FILENAME ":" FNR ": " }
$1 == "date" {
  delete column
  for (i = 1; i <= NF; ++i) column[$i] = i
  columns = NF
  next
}
/^[ \t]*$/ { next }
!columns { fail(place() "no header; is this a games.log?") }
NF != columns { fail(place() NF " values, the header has " columns) }
{
  ++lines
  for (name in column) value[lines, name] = $(column[name])
  where[lines] = place()
  ++inGames[value[lines, "left"]]
  if (value[lines, "right"] != value[lines, "left"]) ++inGames[value[lines, "right"]]
}
function add(row, measure, x) {
  sum[row, measure] += x
  squares[row, measure] += x * x
}
# Mean and half the width of its interval.
function average(row, measure,    n, mean, variance, t) {
  n = games[row]
  mean = sum[row, measure] / n
  if (n < 2) return sprintf("%7.2f       ", mean)
  variance = (squares[row, measure] - n * mean * mean) / (n - 1)
  if (variance < 0) variance = 0
  t = n - 1 <= 30 ? quantile[n - 1] : 1.96 + 2.4 / (n - 1)
  return sprintf("%7.2f ±%5.2f", mean, t * sqrt(variance / n))
}
function take(row, line,    own, other, d) {
  if (!(row in games)) order[++rows] = row
  own = value[line, "left"] == team ? "left" : "right"
  other = own == "left" ? "right" : "left"
  ++games[row]
  d = value[line, "score_" own] - value[line, "score_" other]
  ++outcome[row, d > 0 ? "won" : d < 0 ? "lost" : "drawn"]
  add(row, "for", value[line, "score_" own])
  add(row, "against", value[line, "score_" other])
  add(row, "difference", d)
  add(row, "falls", value[line, "falls_" own])
  add(row, "falls_other", value[line, "falls_" other])
  add(row, "kicks", value[line, "kicks_" own])
  add(row, "kicks_other", value[line, "kicks_" other])
}
function show(name, row,    i, text) {
  text = sprintf("%-20s %5d %5d %5d %5d", substr(name, 1, 20), games[row], outcome[row, "won"], outcome[row, "drawn"], outcome[row, "lost"])
  for (i = 1; i <= 7; ++i) text = text "  " average(row, measures[i])
  print text
}
END {
  if (failed) exit 2
  if (!lines) fail("no games")
  if (team == "") {
    for (name in inGames) if (inGames[name] == lines) { ++candidates; team = name }
    if (candidates != 1) fail("which team is ours? " (candidates ? "Several are" : "None is") " in all games: give --team")
  } else if (!(team in inGames)) fail("no game of team " team)
  for (line = 1; line <= lines; ++line) {
    if (value[line, "left"] != team && value[line, "right"] != team) { ++others; continue }
    if (value[line, "end"] != "over") { ++broken; reasons[value[line, "end"]]++; continue }
    ++counted
    opponent = value[line, "left"] == team ? value[line, "right"] : value[line, "left"]
    take(step ? "games " (int((counted - 1) / step) * step + 1) : opponent, line)
    take("all", line)
  }
  if (counted) {
    printf "%s against ..., mean of a game and 95 %% confidence\n", team
    printf "%-20s %5s %5s %5s %5s", step ? "" : "opponent", "games", "won", "drawn", "lost"
    printf "  %-14s  %-14s  %-14s  %-14s  %-14s  %-14s  %-14s\n", "  goals", "  goals against", "  difference", "  falls", "  falls other", "  kicks", "  kicks other"
    for (i = 1; i <= rows; ++i) {
      if (order[i] == "all") continue
      name = order[i]
      if (step) name = name " to " (substr(name, 7) + games[order[i]] - 1)
      show(name, order[i])
    }
    if (rows > 2) show("all", "all")
  }
  for (reason in reasons) printf "%d not counted: %s\n", reasons[reason], reason
  if (!counted) fail("no game came to its end")
}
