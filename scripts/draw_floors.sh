#!/usr/bin/env bash
# Draws the folders of src/ as SVG: how large each is, and which folder includes from which. An arrow that a way through
# other folders replaces is left out (tred). Folders that include each other in a circle are red.
#   scripts/draw_floors.sh [TREE]      TREE is the root of any state of the project [this one]; the SVG goes to stdout
# Examples: scripts/draw_floors.sh > floors.svg
#   git worktree add /tmp/before 90fa85d && scripts/draw_floors.sh /tmp/before > before.svg
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
(($# <= 1)) || { echo "draw_floors.sh: one tree at most; see --help" >&2; exit 2; }
tree=${1:-$(dirname "${BASH_SOURCE[0]}")/..}
[[ -d $tree/src ]] || { echo "draw_floors.sh: $tree has no folder src" >&2; exit 2; }
cd "$tree"

find src -mindepth 2 -type f \( -name '*.h' -o -name '*.cpp' -o -name '*.c' -o -name '*.y' -o -name '*.l' \) -print0 |
  LC_ALL=C sort -z | xargs -0 awk '
  FNR == 1 { split(FILENAME, path, "/"); here = path[2]; ++files[here] }
  { ++lines[here] }
  /^[ \t]*#[ \t]*include[ \t]*"/ {
    there = $0
    sub(/^[^"]*"/, "", there); sub(/".*/, "", there)
    if (sub(/\/.*/, "", there) && there != here) uses[here, there] = 1
  }
  function reaches(a, b, seen,   i, parts) { # whether a way of includes leads from a to b
    for (i in uses) {
      split(i, parts, SUBSEP)
      if (parts[1] != a || (parts[2] in seen)) continue
      if (parts[2] == b) return 1
      seen[parts[2]] = 1
      if (reaches(parts[2], b, seen)) return 1
    }
    return 0
  }
  END {
    print "digraph floors {\n  bgcolor=white; nodesep=0.25; ranksep=0.45"
    print "  node [shape=box style=\"rounded,filled\" fillcolor=\"#eef3fa\" color=\"#5b7aa6\" fontname=Helvetica fontsize=12 margin=\"0.12,0.06\"]"
    print "  edge [color=\"#8a97a8\" arrowsize=0.6]"
    count = asorted(names)
    for (i = 1; i <= count; ++i) {
      name = names[i]
      delete seen
      circle = reaches(name, name, seen) ? " color=\"#b3261e\" fillcolor=\"#fbe9e7\"" : ""
      printf "  \"%s\" [label=<<b>%s</b><br/><font point-size=\"9\">%d files, %d lines</font>>%s]\n", name, name, files[name], lines[name], circle
      for (k = 1; k <= count; ++k)
        if ((name, names[k]) in uses) printf "  \"%s\" -> \"%s\"\n", name, names[k]
    }
    print "}"
  }
  function asorted(names,   name, n, i, j, t) {
    for (name in files) names[++n] = name
    for (i = 2; i <= n; ++i) for (j = i; j > 1 && names[j - 1] > names[j]; --j) { t = names[j]; names[j] = names[j - 1]; names[j - 1] = t }
    return n
  }' | tred 2> /dev/null | dot -Tsvg
