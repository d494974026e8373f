# Reads games.log. Of each game that is over a line for each team. In it: name, goals for, against, falls, kicks.
# Then: robots within 1.5 m of the ball, pairs of mates nearer than 0.4 m per robot and minute, how far the ball is in the other half [m].
# Then: shots, possession [%], touching, charging, illegal defence, free kicks against, passes, completed ones.
# Then: players that ended before the game or with an error, late cycles of a player, its CPU per cycle (mean, 99th percentile [us]),
# cycles late by the clock. These in real time alone: in step all wait for each other, and that says how busy the machine was.
# Then: approach [m/s], the median speed with which the player nearest to the ball comes nearer to it. It counts from the second second
# on: from 1.5 m away, upright, in play, to a ball that moves less than 0.25 m between two scenes.
# Last: seed, and who ended so. A dash: nothing is known. Of a team that is not ours, those players have ended that are missing in
# the last scene. What happened comes from games.log (doc/how-to/play-games.md), a dash where it is too old for that. Possession: of
# the scenes with a robot within 1 m of the ball, those where the nearest one is of the team. The tracks are played/N/track.csv in
# the order of the seeds; players.sh has written players.tsv there. Variables: played, realtime.
BEGIN { FS = ","; OFS = "\t" }
$1 == "date" { for (i = 1; i <= NF; ++i) column[$i] = i; next }
$column["end"] != "over" { next }
{
  seed = $column["seed"]
  if (!first || seed < first) first = seed
  row[seed] = $0
  if (seed > last) last = seed
}
function flush(   side, i, j, n, d, least) {
  if (!hasBall) return
  ++scenes
  nearest = ""
  least = 1
  here["left"] = count["left"] + 0; here["right"] = count["right"] + 0
  for (side in count) {
    n = count[side]
    if (n > most[side]) most[side] = n
    robots[side] += n
    for (i = 1; i <= n; ++i) {
      d = sqrt((x[side, i] - ballX) ^ 2 + (y[side, i] - ballY) ^ 2)
      if (d < 1.5) ++near[side]
      if (d < least) { least = d; nearest = side }
      for (j = 1; j < i; ++j) if ((x[side, i] - x[side, j]) ^ 2 + (y[side, i] - y[side, j]) ^ 2 < 0.16) ++close_[side]
    }
  }
  if (nearest != "") ++first_[nearest]
  approach()
  hasBall = 0
  delete count
}
# Of each team: the player that was nearest in the scene before, and whether it came nearer to where the ball was then.
function approach(   side, i, d, least, went) {
  for (side in here) {
    went = 0
    for (i = 1; i <= count[side]; ++i) {
      if (who_[side] != number[side, i]) continue
      d = sqrt((x[side, i] - beforeX) ^ 2 + (y[side, i] - beforeY) ^ 2)
      went = mode == "PlayOn" && modeBefore == "PlayOn" && now - before < 0.75 && (ballX - beforeX) ^ 2 + (ballY - beforeY) ^ 2 < 0.0625 && \
        up[side, i] > 0.9 && d > 1.5 && d < far[side]
      if (!went) continue
      stretch[side] = walks[side] == who_[side] ? stretch[side] + 1 : 1
      walks[side] = who_[side]
      if (stretch[side] > 2) speed[side, ++speeds[side]] = (far[side] - d) / (now - before)
    }
    if (!went) walks[side] = 0
    least = 1e9
    who_[side] = 0
    for (i = 1; i <= count[side]; ++i) {
      d = sqrt((x[side, i] - ballX) ^ 2 + (y[side, i] - ballY) ^ 2)
      if (d < least) { least = d; who_[side] = up[side, i] > 0.9 ? number[side, i] : 0 }
    }
    far[side] = least
  }
  before = now; modeBefore = mode; beforeX = ballX; beforeY = ballY
}
function median(side,   i, j, v, n) {
  n = speeds[side]
  for (i = 2; i <= n; ++i) { v = speed[side, i]; for (j = i; j > 1 && speed[side, j - 1] > v; --j) speed[side, j] = speed[side, j - 1]; speed[side, j] = v }
  return n ? speed[side, int((n + 1) / 2)] : "-"
}
function track(file,   f, n) {
  delete speed; delete speeds; delete walks; delete who_; before = -9
  delete near; delete close_; delete robots; delete count; delete first_; delete most; delete here
  scenes = hasBall = sumX = 0
  while ((getline line < file) > 0) {
    n = split(line, f, ",")
    if (n < 7 || f[1] == "time") continue
    if (f[2] == "ball") { flush(); hasBall = 1; now = f[1]; mode = f[7]; ballX = f[4]; ballY = f[5]; sumX += ballX; ++balls; continue }
    ++count[f[2]]; x[f[2], count[f[2]]] = f[4]; y[f[2], count[f[2]]] = f[5]; number[f[2], count[f[2]]] = f[3]; up[f[2], count[f[2]]] = f[6]
  }
  close(file)
  flush()
}
# What the players of the game cost and how they ended.
function players(file,   f, side) {
  delete known; delete crashes; delete late; delete cpu; delete highest; delete lateByClock; delete measured; delete who
  while ((getline line < file) > 0) {
    split(line, f, "\t")
    side = f[1]
    ++known[side]
    # Who is still at work when the game is over is asked to end, twice under load, and then ends with 143.
    if (f[4] || (f[3] != "0" && f[3] != "1" && f[3] != "143")) { ++crashes[side]; who[side] = who[side] " " f[2] "(" f[3] ")" }
    if (f[5] == "-") continue
    ++measured[side]
    late[side] += f[5]; cpu[side] += f[6]; highest[side] += f[7]; lateByClock[side] += f[8]
  }
  close(file)
}
function ofPlayers(sum, side) { return measured[side] ? sum[side] / measured[side] : "-" }
function report(side, other, sign,   minutes) {
  minutes = robots[side] * 0.5 / 60
  print v[column[side]], v[column["score_" side]], v[column["score_" other]], v[column["falls_" side]], v[column["kicks_" side]], \
    near[side] / scenes, close_[side] / minutes, sign * sumX / scenes, (("shots_" side) in column ? v[column["shots_" side]] : "-"), \
    100 * first_[side] / (first_["left"] + first_["right"] + 1e-9), \
    v[column["touching_" side]], v[column["charging_" side]], v[column["illegal_defence_" side]], v[column["free_kicks_against_" side]], \
    v[column["passes_" side]], v[column["passes_completed_" side]], known[side] ? crashes[side] + 0 : most[side] - here[side], ofPlayers(late, side), \
    ofPlayers(cpu, side), ofPlayers(highest, side), (realtime ? ofPlayers(lateByClock, side) : "-"), median(side), v[column["seed"]], who[side]
}
END {
  for (s = first; s <= last; ++s) {
    if (!(s in row)) continue
    split(row[s], v, ",")
    track(played "/" (s - first + 1) "/track.csv")
    if (!scenes) continue
    players(played "/" (s - first + 1) "/players.tsv")
    report("left", "right", 1)
    report("right", "left", -1)
  }
}
