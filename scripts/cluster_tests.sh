#!/usr/bin/env bash
# Runs the tests of tests/cluster: Open MPI, network namespaces and a Slurm of their own on this machine; what stands behind
# `make cluster`. One after the other, and whatever they start is ended with them, also by Ctrl-C.
#   scripts/cluster_tests.sh [NAME]...     mpi, namespaces, slurm [all]
# Logs go to build/SimRelease/logs/cluster-NAME.log. The last line is "N passed, N failed"; a test that this machine does not
# allow is listed as left out.
# Example: scripts/cluster_tests.sh mpi
set -uo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
logs=build/SimRelease/logs
mkdir -p "$logs"
names=("$@")
if ((!$#)); then for path in tests/cluster/*.sh; do path=${path##*/}; names+=("${path%.sh}"); done; fi
for name in "${names[@]}"; do
  [[ -f tests/cluster/$name.sh ]] || { echo "cluster_tests.sh: no tests/cluster/$name.sh" >&2; exit 2; }
done

running=""
ended() {
  trap '' INT TERM HUP
  if [[ $running ]]; then
    kill "$running" 2> /dev/null
    wait "$running"
  fi
  echo "cluster_tests.sh: ended; what the tests started has ended too" >&2
  exit 130
}
trap ended INT TERM HUP

passed=0 failed=0
for name in "${names[@]}"; do
  log=$logs/cluster-$name.log begin=$SECONDS status=0
  echo "      $name: tail -f $log tells how far it is"
  # In the background, so that a signal is answered at once; timeout hands it on.
  timeout -k 30 3600 bash "tests/cluster/$name.sh" > "$log" 2>&1 < /dev/null &
  running=$!
  wait "$running" || status=$?
  running=""
  case $status in
    0) passed=$((passed + 1)); echo "ok    $name $((SECONDS - begin)) s" ;;
    77) echo "      $name: $(tail -1 "$log")" ;;
    *) failed=$((failed + 1)); echo "FAIL  $name $((SECONDS - begin)) s, status $status, log: $log"; tail -20 "$log" ;;
  esac
done
echo
echo "$passed passed, $failed failed"
((failed == 0))
