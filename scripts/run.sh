#!/usr/bin/env bash
# What `make run` starts once everything is built: one game.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
exec bin/game "$@"
