#!/usr/bin/env bash
# Prints the targets there are: the presets that can be configured, a line each, sorted.
# Example: scripts/list_targets.sh
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit
for file in CMakePresets.json CMakeUserPresets.json; do [[ -f $file ]] && cat "$file"; done | awk '
  /"configurePresets"/ { configure = 1 }
  /"[a-bd-z][a-z]*Presets"/ { configure = 0 }
  configure && match($0, /"name": *"[^"]*"/) { name = substr($0, RSTART, RLENGTH); gsub(/"name": *|"/, "", name); names[name] = 1 }
  /"hidden": *true/ { delete names[name] }
  END { for (name in names) print name }' | LC_ALL=C sort
