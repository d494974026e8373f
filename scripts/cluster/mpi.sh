#!/usr/bin/env bash
# A search as one job of Open MPI: bin/optserver at rank 0, a worker at every other one. What they say to each other goes
# over MPI (bin/mpitunnel), so that no port is open between nodes. Everything of it is in FOLDER, which all nodes see.
#   scripts/cluster/mpi.sh run STUDY FOLDER [OPTION...]             here and now; OPTION: of mpirun, as -n 8 --hostfile FILE
#   scripts/cluster/mpi.sh submit STUDY FOLDER RANKS [OPTION...]    as a job of Slurm. OPTION: of sbatch, as --partition=short
# A job that is preempted is queued again (--requeue). What was evaluated is kept, and the same command continues from it.
# Examples:
#   scripts/cluster/mpi.sh run config/optimisation/standUpFront.yaml ~/searches/front -n 8 --hostfile hosts
#   scripts/cluster/mpi.sh submit config/optimisation/standUpFront.yaml ~/searches/front 31 --partition=short
set -euo pipefail
root=${PLUMBLINE_ROOT-$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)}
usage() { sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$root/scripts/cluster/mpi.sh"; }
fail() { echo "mpi.sh: $*" >&2; exit 2; }

# The folder as a whole path, and in it a token: a port on loopback is open to everybody else on its node.
prepare() {
  [[ -f $1 ]] || fail "$1: no such study"
  study=$(realpath "$1")
  mkdir -p "$2"
  folder=$(cd "$2" && pwd)
  [[ -s $folder/token ]] || (umask 077 && head -c 24 /dev/urandom | od -An -tx1 | tr -d ' \n' > "$folder/token")
}

submit() {
  (($# >= 3)) || fail "submit needs STUDY, FOLDER and RANKS"
  local ranks=$3
  [[ $ranks =~ ^[1-9][0-9]{0,3}$ ]] && ((ranks >= 2)) || fail "RANKS is \"$ranks\" and must be a number from 2 to 9999"
  command -v sbatch > /dev/null || fail "there is no sbatch: this is no node that submits jobs"
  prepare "$1" "$2"
  shift 3
  export PLUMBLINE_ROOT=$root # jobs run a copy of this script
  local job
  job=$(sbatch --parsable --requeue --open-mode=append --job-name=mpisearch --ntasks="$ranks" --output="$folder/server.log" \
    "$@" "$root/scripts/cluster/mpi.sh" run "$study" "$folder")
  echo "job ${job%%;*}; how far it is: tail -f $folder/server.log"
}

run() {
  (($# >= 2)) || fail "run needs STUDY and FOLDER"
  command -v mpirun > /dev/null || fail "there is no mpirun: make cluster installs it"
  [[ -x $root/bin/mpitunnel ]] || fail "there is no bin/mpitunnel: make bin/mpitunnel builds it where libopenmpi-dev is installed"
  prepare "$1" "$2"
  shift 2
  PLUMBLINE_TOKEN=$(< "$folder/token")
  export PLUMBLINE_TOKEN
  exec mpirun -x PLUMBLINE_TOKEN "$@" "$root/bin/mpitunnel" --again -- \
    "$root/bin/optserver" "$study" --folder "$folder" --port {port} --every 60 -- \
    "$root/bin/optworker" --port {port} --patience 60
}

case ${1-} in
  submit | run) "$@" ;;
  -h | --help) usage ;;
  *) usage >&2; exit 2 ;;
esac
