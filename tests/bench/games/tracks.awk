# Reads games.log; of each game that is over a line for each team: name, goals for, against, falls, kicks, robots within 1.5 m of
# the ball, pairs of mates nearer than 0.4 m per robot and minute, how far the ball is in the other half [m], seed. The
# tracks are played/N/track.csv in the order of the seeds. Variables: played.
BEGIN { FS = ","; OFS = "\t" }
$1 == "date" { for (i = 1; i <= NF; ++i) column[$i] = i; next }
$column["end"] != "over" { next }
{
  seed = $column["seed"]
  if (!first || seed < first) first = seed
  row[seed] = $0
  if (seed > last) last = seed
}
function flush(   side, i, j, n, d) {
  if (!hasBall) return
  ++scenes
  for (side in count) {
    n = count[side]
    robots[side] += n
    for (i = 1; i <= n; ++i) {
      d = sqrt((x[side, i] - ballX) ^ 2 + (y[side, i] - ballY) ^ 2)
      if (d < 1.5) ++near[side]
      for (j = 1; j < i; ++j) if ((x[side, i] - x[side, j]) ^ 2 + (y[side, i] - y[side, j]) ^ 2 < 0.16) ++close_[side]
    }
  }
  hasBall = 0
  delete count
}
function track(file,   f, n) {
  delete near; delete close_; delete robots; delete count
  scenes = hasBall = sumX = 0
  while ((getline line < file) > 0) {
    n = split(line, f, ",")
    if (n < 7 || f[1] == "time") continue
    if (f[2] == "ball") { flush(); hasBall = 1; ballX = f[4]; ballY = f[5]; sumX += ballX; ++balls; continue }
    ++count[f[2]]; x[f[2], count[f[2]]] = f[4]; y[f[2], count[f[2]]] = f[5]
  }
  close(file)
  flush()
}
function report(side, other, sign,   minutes) {
  minutes = robots[side] * 0.5 / 60
  print v[column[side]], v[column["score_" side]], v[column["score_" other]], v[column["falls_" side]], v[column["kicks_" side]], \
    near[side] / scenes, close_[side] / minutes, sign * sumX / scenes, v[column["seed"]]
}
END {
  for (s = first; s <= last; ++s) {
    if (!(s in row)) continue
    split(row[s], v, ",")
    track(played "/" (s - first + 1) "/track.csv")
    if (!scenes) continue
    report("left", "right", 1)
    report("right", "left", -1)
  }
}
