#!/usr/bin/env bash
# Makes the pictures of doc/img/ and README's sample output anew, by the commands that stand beside them there; `make
# pictures` builds first what this needs.
#   scripts/make_pictures.sh [goal] [match] [team] [graph] [floors] [walk] [report] [agent] [fault] [situations]
#     all, if none is named
# The report takes some minutes. Times in the graph of modules are true on a machine that does nothing else.
# Example: scripts/make_pictures.sh goal
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
fail() { echo "make_pictures.sh: $*" >&2; exit 2; }
wanted=("$@")
((${#wanted[@]})) || wanted=(goal match team graph floors walk report agent fault situations)
work=$(mktemp -d)
server=""
trap '[[ $server ]] && kill "$server" 2> /dev/null; rm -rf "$work"' EXIT

# Into doc/img/ at once and whole.
put() { mv "$1" "doc/img/.$2.part"; mv "doc/img/.$2.part" "doc/img/$2"; echo "doc/img/$2"; }
look() { node tests/e2e/web/look.mjs "$@" > "$work/look.log" 2>&1 || fail "the browser: $(tail -3 "$work/look.log")"; }

goal() {
  scripts/run.sh --output "$work/game" | grep -v "^watch at " > "$work/game.out"  # the page is there for the length of the game
  put "$work/game/track.svg" first-goal.svg
  # The block of text below the picture.
  awk -v sample="$work/game.out" '
    BEGIN { while ((getline line < sample) > 0) lines[++n] = line; sub(/;.*/, "", lines[n]) }
    { print }
    /first-goal.svg/ { below = 1 }
    below && /^```text/ {
      print lines[1]; print lines[2]; print "  ..."; print lines[n - 1]; print lines[n]
      while ((getline line) > 0) if (line == "```") break
      print line; below = 0
    }' README.md > "$work/README.md"
  cat "$work/README.md" > README.md
  echo README.md
}

# A match of the recording's name, with options of scripts/match.sh; its replay as a picture: second of the game, and from where.
matchPicture() { # name, second, eye, options...
  local name=$1 second=$2 eye=$3
  shift 3
  scripts/match.sh --fast --page 0 --record "$work/$name.plm" "$@" > "$work/match.log" || fail "$(cat "$work/match.log")"
  (cd "$work" && exec "$OLDPWD/bin/webmonitor" --replay "$name.plm" --web-port 0 > "$name.log") &
  server=$!
  until grep -qs http "$work/$name.log"; do kill -0 $server || fail "$(cat "$work/$name.log")"; sleep 0.1; done
  node tests/e2e/web/moment.mjs "$(sed -n 's#.*\(http://localhost:[0-9]*/\).*#\1#p' "$work/$name.log")" "$work/$name.jpg" "$second" "$eye" \
    > "$work/look.log" || fail "the browser: $(tail -3 "$work/look.log")"
  kill $server
  server=""
}

match() {
  matchPicture match 25 -2.5,-8.5,4 --seconds 40 --seed 1
  put "$work/match.jpg" webmonitor.jpg
}

# Roles, ways and beliefs of a team of four.
team() {
  matchPicture team 12 -1,-9,9 --left 5 --right 1 --seconds 20 --seed 2 --draw team,belief:robots,belief:ball
  put "$work/team.jpg" team-drawings.jpg
}

# With what each module takes on the way to a goal.
graph() {
  bin/simulator --port 0 --monitor-port 0 --ports-file "$work/graphPorts.json" --sync --kickoff-after 2 --seed 1 --max-seconds 30 \
    > "$work/simulator.log" 2>&1 &
  server=$!
  until [[ -s $work/graphPorts.json ]]; do kill -0 $server || fail "$(cat "$work/simulator.log")"; sleep 0.1; done
  bin/agent --port "$(sed -n 's/.*"agent": \([0-9]*\).*/\1/p' "$work/graphPorts.json")" --graph "$work/modules.svg" --timing \
    > "$work/graph.log" 2>&1 &
  local agent=$!
  wait $server || fail "$(cat "$work/simulator.log")"
  server=""
  kill -INT $agent
  wait $agent || fail "the agent: $(tail -1 "$work/graph.log")"
  put "$work/modules.svg" modules.svg
}

floors() {
  scripts/draw_floors.sh > "$work/floors.svg"
  put "$work/floors.svg" floors.svg
}

# The page of `make bench-walk`, of one robot and a few runs, at the figure that shows how the walk is planned.
walk() {
  build/SimRelease/bench/walking 2 0.1 20 --robots type0 --sections estimate --name walk-picture > "$work/walk.log" 2>&1 ||
    fail "$(tail -1 "$work/walk.log")"
  look "file://$PWD/build/bench/walk-picture.html" "$work/walk.png" 1240 740 1 \
    "[...document.querySelectorAll('figure')].find(f => f.textContent.includes('Figures 4.5')).scrollIntoView()"
  put "$work/walk.png" walk-page.png
}

# By README's own commands.
report() {
  sed -n '/^bin\/gap record --battery/,/^bin\/gap report/p' README.md > "$work/report.sh"
  grep -q 'gap report' "$work/report.sh" || fail "README has no commands of a diagnosis"
  ln -s "$PWD/bin" "$work/bin"
  (cd "$work" && bash -e report.sh) > "$work/report.log" 2>&1 || fail "$(tail -1 "$work/report.log")"
  look "file://$work/report.html" "$work/report.png" 1240 1330 4
  put "$work/report.png" gap-report.png
}

# The page of an agent that walks to the ball, beside its simulator.
agent() {
  local shown="text=representation:BallPos&plot=representation:BallPos.relative.x,representation:BallPos.relative.y"
  shown+="&text=representation:SkillRequest&parameter=config:BallLocator.forgetSeconds&place=representation:BallPos.field,field"
  local name
  for name in FKModel:body RobotPose AugmentedSelfLocator:particles BallLocator:ball BehaviorCombinator:target WalkingEngine:steps; do
    shown+="&draw=draw:$name"
  done
  bin/simulator --port 0 --monitor-port 0 --ports-file "$work/ports.json" --seed 1 --realtime > "$work/simulator.log" &
  server=$!
  until [[ -s $work/ports.json ]]; do kill -0 $server || fail "$(cat "$work/simulator.log")"; sleep 0.1; done
  bin/agent --port "$(sed -n 's/.*"agent": \([0-9]*\).*/\1/p' "$work/ports.json")" --web 0 > /dev/null 2> "$work/agent.log" &
  local agent=$!
  until grep -qs 'page http' "$work/agent.log"; do kill -0 $agent || fail "$(cat "$work/agent.log")"; sleep 0.1; done
  node tests/e2e/web/agent_moment.mjs "$(sed -n 's#.*page \(http://localhost:[0-9]*/\)$#\1#p' "$work/agent.log")" "$work/agent.jpg" "$shown" \
    > "$work/look.log" 2>&1 || fail "the browser: $(tail -3 "$work/look.log")"
  kill -INT $agent
  wait $agent || fail "the agent: $(tail -1 "$work/agent.log")"
  kill $server
  server=""
  put "$work/agent.jpg" agent-page.jpg
}

# What a terminal shows, as a picture: the text on standard input; the line that begins with " rdb " is its bar.
terminalPicture() {
  awk '
    { gsub(/&/, "\\&amp;"); gsub(/</, "\\&lt;"); gsub(/>/, "\\&gt;"); line[NR] = $0 }
    END {
      printf "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 860 %d\" font-family=\"DejaVu Sans Mono, Menlo, Consolas, monospace\" font-size=\"13\">\n", 18 * NR + 12
      printf "<rect width=\"100%%\" height=\"100%%\" rx=\"6\" fill=\"#16202b\"/>\n"
      for (i = 1; i <= NR; ++i) {
        bar = line[i] ~ /^ rdb /
        if (bar) printf "<rect x=\"6\" y=\"%d\" width=\"848\" height=\"18\" fill=\"#c8d2dc\"/>\n", 18 * i - 8
        if (bar) above = 1
        printf "<text x=\"10\" y=\"%d\" xml:space=\"preserve\" fill=\"%s\"%s>%s</text>\n", 18 * i + 6, bar ? "#16202b" : above ? "#c8d2dc" : "#ffe13c", above ? "" : " font-weight=\"bold\"", line[i]
      }
      print "</svg>"
    }'
}

# The fault of doc/how-to/find-a-fault.md: what the page shows of it, and the console.
fault() {
  local shown="text=representation:BallPos&plot=representation:BallPercept.seen,representation:LocalBallPos.valid"
  shown+="&text=representation:SkillRequest&parameter=config:BallLocator.forgetSeconds&place=representation:RobotPose.position,field"
  shown+="&draw=draw:BallLocator:ball&draw=draw:RobotPose&draw=draw:BehaviorCombinator:target&draw=draw:SkillCombinator:request"
  bin/simulator --port 0 --monitor-port 0 --ports-file "$work/faultPorts.json" --seed 1 --realtime > "$work/simulator.log" &
  server=$!
  until [[ -s $work/faultPorts.json ]]; do kill -0 $server || fail "$(cat "$work/simulator.log")"; sleep 0.1; done
  bin/agent --port "$(sed -n 's/.*"agent": \([0-9]*\).*/\1/p' "$work/faultPorts.json")" --web 0 --debug 0 > /dev/null 2> "$work/fault.log" &
  local agent=$! terminal=(tmux -L "plumbline-pictures-$$" -f /dev/null) debug line
  until grep -qs 'page http' "$work/fault.log" && grep -qs 'debug port' "$work/fault.log"; do
    kill -0 $agent || fail "$(cat "$work/fault.log")"
    sleep 0.1
  done
  debug=$(sed -n 's/.*debug port \(127.0.0.1:[0-9]*\):.*/\1/p' "$work/fault.log")
  bin/rdb "$debug" --exec "set r:GameState.playMode 3" --exec "set c:BallLocator.forgetSeconds 0.01"
  node tests/e2e/web/agent_moment.mjs "$(sed -n 's#.*page \(http://localhost:[0-9]*/\)$#\1#p' "$work/fault.log")" "$work/fault.jpg" "$shown" 5 BallLocator moveToPos \
    > "$work/look.log" 2>&1 || fail "the browser: $(tail -3 "$work/look.log")"
  LC_ALL=C.UTF-8 XDG_STATE_HOME="$work/state" "${terminal[@]}" new-session -d -x 108 -y 24 "bin/rdb $debug"
  sleep 1
  for line in "watch r:BallPos.valid" "watch r:SkillRequest.skill" "plot r:BallPercept.seen ball" "plot r:LocalBallPos.valid ball" \
    "get m:BallLocator:onField" "about c:BallLocator.forget" "get c:BallLocator.forgetSeconds"; do
    "${terminal[@]}" send-keys -l "$line"
    "${terminal[@]}" send-keys Enter
    sleep 0.5
  done
  sleep 4
  "${terminal[@]}" capture-pane -p | sed 's/127.0.0.1:[0-9]*/127.0.0.1:3300/' > "$work/rdb.txt"
  "${terminal[@]}" kill-server
  terminalPicture < "$work/rdb.txt" > "$work/rdb.svg"
  kill -INT $agent
  wait $agent || fail "the agent: $(tail -1 "$work/fault.log")"
  kill $server
  server=""
  put "$work/fault.jpg" fault-page.jpg
  put "$work/rdb.svg" rdb.svg
}

# Those of tests/data/situations/, and the page that shows them.
situations() {
  rm -rf doc/img/situations
  bin/situations page tests/data/situations --pictures doc/img/situations -o doc/reference/situations.md
}

for name in "${wanted[@]}"; do
  case $name in
    goal | match | team | graph | floors | walk | report | agent | fault | situations) "$name" ;;
    *) fail "no picture '$name'; there is goal, match, team, graph, floors, walk, report, agent, fault, situations" ;;
  esac
done
