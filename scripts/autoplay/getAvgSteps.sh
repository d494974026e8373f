#!/usr/bin/env bash
# Reads games.log and shows the average game of each ten games, or so many, in their order: whether a team gets
# better (thesis A.5).
set -euo pipefail
step=10 stepHelp="  --step N      games in a row of the table [10]"
source "$(dirname "${BASH_SOURCE[0]}")/averages.bash"
showAverages "$@"
