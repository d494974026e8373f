#!/usr/bin/env bash
# A search on a cluster with Slurm: a job for bin/optserver and an array of jobs for its workers, which join and leave as the
# cluster lets them. Everything of it is in FOLDER, which all nodes see: address, token, results, logs.
#   scripts/cluster/search.sh submit STUDY FOLDER WORKERS [OPTION...]   OPTION: of both sbatch calls, as --partition=short
#   scripts/cluster/search.sh server STUDY FOLDER                      what the one job runs
#   scripts/cluster/search.sh worker FOLDER                            what each job of the array runs
# A job that is preempted is queued again (--requeue): the server goes on from its results, a worker begins with another trial.
# Example: scripts/cluster/search.sh submit config/optimisation/standUpFront.yaml ~/searches/front 30 --partition=short
set -euo pipefail
root=${PLUMBLINE_ROOT-$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)}
usage() { sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$root/scripts/cluster/search.sh"; }
fail() { echo "search.sh: $*" >&2; exit 2; }
patience=${PLUMBLINE_WAIT-600} # seconds that a worker waits for a server

submit() {
  (($# >= 3)) || fail "submit needs STUDY, FOLDER and WORKERS"
  local study=$1 folder=$2 workers=$3
  shift 3
  [[ -f $study ]] || fail "$study: no such study"
  [[ $workers =~ ^[1-9][0-9]{0,3}$ ]] || fail "WORKERS is \"$workers\" and must be a number from 1 to 9999"
  command -v sbatch > /dev/null || fail "there is no sbatch: this is no node that submits jobs"
  mkdir -p "$folder"
  folder=$(cd "$folder" && pwd)
  study=$(realpath "$study")
  rm -f "$folder/over"
  # Whoever has it may take part: it is no one else's to read, and no command line's.
  [[ -s $folder/token ]] || (umask 077 && head -c 24 /dev/urandom | od -An -tx1 | tr -d ' \n' > "$folder/token")
  export PLUMBLINE_ROOT=$root # jobs run a copy of this script
  local server
  server=$(sbatch --parsable --requeue --open-mode=append --job-name=optserver --ntasks=1 --output="$folder/server.log" "$@" \
    "$root/scripts/cluster/search.sh" server "$study" "$folder")
  local array
  array=$(sbatch --parsable --requeue --open-mode=append --job-name=optworker --ntasks=1 --array="1-$workers" \
    --dependency="after:${server%%;*}" --output="$folder/worker-%a.log" "$@" "$root/scripts/cluster/search.sh" worker "$folder")
  echo "server ${server%%;*}, workers ${array%%;*}; how far it is: tail -f $folder/server.log"
}

server() {
  (($# == 2)) || fail "server needs STUDY and FOLDER"
  local study=$1 folder=$2 status=0
  rm -f "$folder/address" "$folder/port"
  # The address is written once the port is open, and whole.
  (
    until [[ -s $folder/port ]]; do sleep 0.2; done
    echo "${SLURMD_NODENAME-$(hostname)} $(< "$folder/port")" > "$folder/address.new"
    mv "$folder/address.new" "$folder/address"
  ) &
  local teller=$!
  PLUMBLINE_TOKEN=$(< "$folder/token") srun --ntasks=1 "$root/bin/optserver" "$study" --folder "$folder" --bind "${PLUMBLINE_BIND-0.0.0.0}" \
    --port 0 --every 60 || status=$?
  kill "$teller" 2> /dev/null || true
  ((status)) || touch "$folder/over"
  exit "$status"
}

worker() {
  (($# == 1)) || fail "worker needs FOLDER"
  local folder=$1 end=$((SECONDS + patience)) host port
  until [[ -f $folder/over ]]; do
    if [[ -s $folder/address ]]; then
      read -r host port < "$folder/address"
      PLUMBLINE_TOKEN=$(< "$folder/token") srun --ntasks=1 "$root/bin/optworker" --host "$host" --port "$port" --patience 5 &&
        end=$((SECONDS + patience))
      # One that ends well saw the end of the search; else the server may come back with another address.
    fi
    ((SECONDS < end)) || fail "no server in $patience s; see $folder/server.log"
    [[ -f $folder/over ]] || sleep 1
  done
}

case ${1-} in
  submit | server | worker) "$@" ;;
  -h | --help) usage ;;
  *) usage >&2; exit 2 ;;
esac
