#!/usr/bin/env bash
# The team's set pieces from places drawn by lot: whether they are taken in time, who has the next touch, how far the ball goes, and
# who has it later, and goals. Settings by the environment: TRIES of each kind [100], SEED of the first [1], JOBS at once [cores],
# PLAYERS on each side [5]. OTHERS: the modules.cfg of the other team [as ours]. KINDS: separated by commas [all]. Writes
# build/bench/set-pieces.json and .md; `make bench-set-pieces` builds
# what it needs and writes doc/results/set-pieces.md.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
exec build/SimRelease/bench/duels --set-pieces
