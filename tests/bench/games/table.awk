# From the lines of tracks.awk: a table in Markdown, and the figures as the project's JSON. Variables: half, json, realtime, and for
# games against a team that is not ours players, of each side, other, what that team is called, server, and played, the day.
BEGIN {
  FS = "\t"
  split("goals for|goals against|falls|kicks|players within 1.5 m of the ball|mates nearer than 0.4 m, seen twice a second, per player and minute|ball in the other half, mean [m]|shots|possession [%]|fouls: touching|charging|illegal defence|free kicks against|passes made|passes completed|players that ended before the game or with an error|late cycles of a player (more than 20 ms of CPU)|CPU of a player per cycle, mean [us]|99th percentile, mean of the players [us]|late cycles of a player by the clock (answer more than 20 ms after the server's message)|way to a resting ball, from the second second on and 1.5 m away, median [m/s]", title, "|")
  measures = split("goals goals_against falls kicks near_ball mates_close ball_ahead shots possession touching charging illegal_defence free_kicks_against passes passes_completed crashes late_cycles cpu cpu_p99 late_cycles_wall approach", name, " ")
  split("higher lower lower higher lower lower higher higher higher lower lower lower lower higher higher lower lower lower lower lower higher", better, " ")
  unit[6] = "1/min"; unit[7] = "m"; unit[9] = "%"; unit[18] = unit[19] = "us"; unit[21] = "m/s"
  target[16] = target[17] = 0; target[18] = 200; target[21] = 1
}
{
  team = $1
  if (!(team in n)) order[++teams] = team
  ++n[team]
  for (i = 1; i <= measures; ++i) if ($(i + 1) != "-") { ++count[team, i]; sum[team, i] += $(i + 1); squares[team, i] += $(i + 1) ^ 2 }
  difference[team] += $2 - $3; differences[team] += ($2 - $3) ^ 2
  if ($2 > $3) ++won[team]; else if ($2 < $3) ++lost[team]; else ++drawn[team]
  seed = $(measures + 2)
  if (!first || seed < first) first = seed
  if (seed > last) last = seed
  if ($(measures + 3) != "") ended = ended " " team ", seed " seed ":" $(measures + 3) "."
}
END {
  if (!teams) { print "no game came to its end" > "/dev/stderr"; exit 1 }
  league = server == "rcssserver3d"
  print players ? "## The team against " (other != "" ? other : "another one") (league ? ", on the league's server" : "") (realtime ? ", in real time" : "") "\n" : "## The team against the players of before it\n"
  printf "%sames of 2 x %s s, %s on %s, sides changed from game to game, seeds %s to %s%s; means of a game with their 95 %% intervals.", \
    (players ? "G" : "Whole g"), half, (players ? players " against " players : "eleven against eleven"), (league ? "the league's server (rcssserver3d)" : "the embedded simulator") (realtime ? " in real time" : ""), first, last, (played ? ", played on " played : "")
  print (players ? "" : " Swarm: every player for itself, all to the ball (`config/platforms/simspark/swarm.cfg`).") "\n"
  printf "| |"; for (t = 1; t <= teams; ++t) printf " %s |", order[t]; print ""
  printf "|---|"; for (t = 1; t <= teams; ++t) printf "---|"; print ""
  printf "| games won, drawn, lost |"; for (t = 1; t <= teams; ++t) printf " %d, %d, %d |", won[order[t]], drawn[order[t]], lost[order[t]]; print ""
  printf "| goal difference |"; for (t = 1; t <= teams; ++t) printf " %.2f ± %.2f |", difference[order[t]] / n[order[t]], half95(difference[order[t]], differences[order[t]], n[order[t]]); print ""
  for (i = 1; i <= measures; ++i) {
    if (name[i] == "late_cycles_wall" && !realtime) continue
    printf "| %s |", title[i]
    for (t = 1; t <= teams; ++t)
      if (count[order[t], i]) printf " %.2f ± %.2f |", sum[order[t], i] / count[order[t], i], half95(sum[order[t], i], squares[order[t], i], count[order[t], i]); else printf " - |"
    print ""
  }
  print "\nEvery goal is a shot, but for own goals; `src/watch/BallTouches.h` says what else is one. A pass is made when another player has the next touch, 1.5 m away or farther, and no shot. It is completed when that player is a mate and the ball stayed in play. The first cycle of a player, in which it gets ready, is not counted as late."
  if (ended != "") print "\nPlayers that ended before the game or with an error, by number and exit status:" ended
  print ""
  key = other; gsub(/[^A-Za-z0-9]+/, "_", key)
  key = key == "" ? "" : tolower(key) "_" players (league ? "_" server : "") (realtime ? "_realtime" : "") "."
  text = "["
  for (t = 1; t <= teams; ++t) {
    team = order[t]
    for (i = 1; i <= measures; ++i) {
      if (!count[team, i]) continue
      text = text sprintf("%s\n  {\"name\": \"games.%s%s.%s\", \"value\": %.4g, \"unit\": \"%s\", \"better\": \"%s\"%s}", \
        (text == "[" ? "" : ","), key, tolower(team), name[i], sum[team, i] / count[team, i], unit[i], better[i], \
        (team == "Team" && i in target ? ", \"target\": " target[i] : ""))
    }
  }
  if (players && n["Team"] > 1) {
    mean = difference["Team"] / n["Team"]
    text = text sprintf(",\n  {\"name\": \"games.%steam.goal_difference\", \"value\": %.4g, \"unit\": \"\", \"better\": \"higher\"}", key, mean)
    text = text sprintf(",\n  {\"name\": \"games.%steam.goal_difference_lower_end\", \"value\": %.4g, \"unit\": \"\", \"better\": \"higher\", \"target\": 0}", key, mean - half95(difference["Team"], differences["Team"], n["Team"]))
  }
  won_ = won["Team"] / n["Team"]
  text = text sprintf(",\n  {\"name\": \"games.%steam.won_of_%d\", \"value\": %.4g, \"unit\": \"\", \"better\": \"higher\"%s}", \
    key, n["Team"], won_, (players ? "" : ", \"target\": 0.95"))
  print text "\n]" > json
}
