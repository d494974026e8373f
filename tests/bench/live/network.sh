#!/usr/bin/env bash
# Representations over the network, measured between processes: build/bench/live_network.json.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../../.."
exec build/SimRelease/bench/network
