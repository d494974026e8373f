#!/usr/bin/env bash
# What `make run` starts once everything is built: one game.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
page=()
[[ -f build/web/index.html && " $* " != *" --host"* ]] && page=(--web)
exec bin/game "${page[@]}" "$@"
