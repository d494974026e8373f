#!/usr/bin/env bash
# Reads games.log and shows the average game against each opponent (thesis A.5).
set -euo pipefail
step=0 stepHelp=""
source "$(dirname "${BASH_SOURCE[0]}")/averages.bash"
showAverages "$@"
