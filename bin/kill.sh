#!/usr/bin/env bash
# Ends the agents that bin/start.sh of this folder started, of all teams or of those named, and no other's.
#   kill.sh [TEAM]...
set -euo pipefail
bin=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
case ${1-} in -h | --help) sed -n '2,3s/^# *//p' "${BASH_SOURCE[0]}"; exit 0 ;; esac

# Prints the agents' process ids.
find_agents() {
  local team file
  while read -r file; do
    team=$(tr '\0' '\n' 2> /dev/null < "$file" | sed -n 's/^PLUMBLINE_TEAM=//p') || continue
    if ((!$#)) || [[ " $* " == *" $team "* ]]; then file=${file#/proc/}; echo "${file%/*}"; fi
  done < <(grep -lzsxF "PLUMBLINE_START=$bin" /proc/[0-9]*/environ 2> /dev/null)
}

for signal in TERM KILL; do
  mapfile -t agents < <(find_agents "$@")
  ((${#agents[@]})) || exit 0
  kill -$signal "${agents[@]}" 2> /dev/null || true
  for ((i = 0; i < 40; ++i)); do
    [[ $(find_agents "$@") ]] || exit 0
    sleep 0.05
  done
done
echo "kill.sh: these agents do not end: $(find_agents "$@" | tr '\n' ' ')" >&2
exit 1
