# A few of the jobs of `make faults`, `make kills` and `make stops`: the first calls of each kind fail, a program is killed, or a
# signal comes. It ends well or says why, and leaves no half-written file.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
FAULTS_OUT=$(mktemp -d)
export FAULTS_OUT
trap 'rm -rf "$FAULTS_OUT"' EXIT
scripts/faults.sh --quick
scripts/stops.sh --quick
KILLS=2 scripts/kills.sh gap_apply
