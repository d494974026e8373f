#!/usr/bin/env bash
# Ends the agents that bin/start.sh of this folder started, of all teams or of those named, and no other's.
#   kill.sh [TEAM]...
set -euo pipefail
bin=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
case ${1-} in -h | --help) sed -n '2,3s/^# *//p' "${BASH_SOURCE[0]}"; exit 0 ;; esac

program=$(readlink -f "$bin/agent")

# Prints the agents' process ids; a program that was built anew is called "... (deleted)" there.
find_agents() {
  local process team
  for process in /proc/[0-9]*; do
    [[ $(readlink "$process/exe" 2> /dev/null) == "$program"* ]] || continue
    team=$(tr '\0' '\n' 2> /dev/null < "$process/environ" | sed -n 's/^PLUMBLINE_TEAM=//p') || continue
    [[ $team ]] || continue
    if ((!$#)) || [[ " $* " == *" $team "* ]]; then echo "${process#/proc/}"; fi
  done
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
