#!/usr/bin/env bash
# Checks that includes point down the floors of src/ only (doc/architecture.md). Each offender: file:line: why.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

# Ground floor first; "walking" and "motion" stand beside the framework and see only math and robot.
awk '
  BEGIN {
    count = split("math robot framework optimization simspark simulation representations walking motion modules gap training game web main", f, " ")
    for (i = 1; i <= count; ++i) floorOf[f[i]] = i
    split("math robot optimization walking", w, " ")
    for (i in w) walkingMay[w[i]] = 1
  }
  FNR == 1 { split(FILENAME, path, "/"); here = path[2] }
  /^[ \t]*#[ \t]*include[ \t]*"/ {
    target = $0
    sub(/^[^"]*"/, "", target); sub(/".*/, "", target)
    there = target
    if (target ~ /^\.\.?\//) { say("relative include \"" target "\": write the path from src/"); next }
    if (!sub(/\/.*/, "", there) || !(there in floorOf)) next
    if (!(here in floorOf)) { say("folder src/" here " has no floor: add it to scripts/check_floors.sh"); next }
    if ((here == "walking" || here == "motion") && !(there in walkingMay) && there != here) say("src/" here " may include math, robot and optimization only, not \"" target "\"")
    else if (floorOf[there] > floorOf[here]) say("src/" here " must not look up to \"" target "\"")
  }
  function say(what) { print FILENAME ":" FNR ": " what; ++bad }
  END { if (bad) { print "check_floors: " bad " include(s) point up" > "/dev/stderr"; exit 1 } }
' $(find src -type f \( -name '*.h' -o -name '*.cpp' -o -name '*.c' -o -name '*.y' -o -name '*.l' \) | LC_ALL=C sort) < /dev/null
