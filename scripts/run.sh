#!/usr/bin/env bash
# What `make run` starts once everything is built: one game. In a terminal it goes in real time on a page that stays open;
# elsewhere, or without a page, as fast as it goes. Without --seed it is the game that takes the median time of 25 seeds
# (type 0, doc/results/goal.md).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
page=()
if [[ -f build/web/index.html && " $* " != *" --host"* ]]; then
  page=(--web)
  if [[ -t 1 && " $* " != *" --web"* ]]; then page=(--web --realtime --stay); fi
fi
seed=(--seed 3)
[[ " $* " != *" --seed"* ]] || seed=()
exec bin/game "${page[@]}" "${seed[@]}" "$@"
