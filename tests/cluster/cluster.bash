# What the tests of make cluster share: programs that may be missing, a search and what it finds by itself, and processes that have
# to end. Also a Slurm of their own that listens on loopback only.
# Where that is allowed, in a network of its own: mpirun listens for its daemons at all addresses, and nobody reaches them there.
# Slurm's programs listen where the machine's name leads to; names lead nowhere without an address that is not loopback's.
ownNetwork='ip link set lo up && ip link add nobody type dummy && ip address add 10.78.0.1/32 dev nobody &&
  ip link set nobody up && hostname localhost'
if ((EUID == 0)) && [[ ! ${PLUMBLINE_OWN_NETWORK-} ]] && unshare --net --uts bash -c "$ownNetwork" 2> /dev/null; then
  PLUMBLINE_OWN_NETWORK=yes exec unshare --net --uts bash -c "$ownNetwork"' && exec bash "$0"' "$0"
fi
source "$(dirname "${BASH_SOURCE[0]}")/../e2e/assert.bash"
skip() { echo "left out: $*"; exit 77; }
needs() { local name; for name in "$@"; do command -v "$name" > /dev/null || skip "no $name here; make cluster installs it"; done; }

# Open MPI on this machine alone: shared memory between ranks, its own connections on loopback, more ranks than cores.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 OMPI_MCA_rmaps_base_oversubscribe=1
export OMPI_MCA_orte_tmpdir_base=$scratch OMPI_MCA_btl=self,vader OMPI_MCA_oob_tcp_if_include=lo OMPI_MCA_hwloc_base_binding_policy=none
slurm=$scratch/slurm
# Every process that a test starts has this, so that none can hide.
export PLUMBLINE_TEST=$scratch

# A search whose answers depend on nothing but the parameters; $1: seconds that each takes, $2: generations. And what it finds
# undisturbed, without any cluster and without taking its time.
writeStudy() {
  cat > "$scratch/study.yaml" << END
task: function
options: {function: rosenbrock, dimension: 4, sleep: $1, spread: 0.3}
population: 8
ahead: 3
runs: 1
runsOfBest: 2
generations: $2
END
  sed "s/sleep: $1/sleep: 0/" "$scratch/study.yaml" > "$scratch/quick.yaml"
  "$bin/optserver" "$scratch/quick.yaml" --folder "$scratch/alone" --workers 1 --port 0 > "$scratch/alone.out" 2>&1 ||
    fail "the search alone ended with $?: $(tail -3 "$scratch/alone.out")"
}
# Whether a folder ($1) has what was found alone, each trial counted once.
expectAsAlone() {
  cmp <(grep -v '^#' "$scratch/alone/found.yaml") <(grep -v '^#' "$1/found.yaml") || fail "$1: found something else than alone"
  expectEqual "$(sed 1d "$1/evaluations.jsonl" | sed 's/.*"trial":\([0-9]*\).*/\1/' | sort | uniq -d | wc -l)" 0 "trials counted twice in $1"
}
results() { { sed 1d "$1/evaluations.jsonl" 2> /dev/null || true; } | wc -l; }
hasResults() { (($(results "$1") >= $2)); }

# Processes that this test started, whatever became of their parents, but those that have ended and wait for someone to notice.
# Each has its mark in its environment, or, as slurmstepd has no such, its folder. $1: a pattern of their names [all].
left() {
  local pid name
  { grep -lsz "^PLUMBLINE_TEST=$scratch$" /proc/[0-9]*/environ || true
    find /proc/[0-9]* -maxdepth 1 -name cwd -lname "$slurm*" 2> /dev/null || true; } | sed 's#^/proc/##; s#/.*##' | sort -un |
    while read -r pid; do
      name=$(cat "/proc/$pid/comm" 2> /dev/null) || continue
      [[ $(sed 's/.*) //' "/proc/$pid/stat" 2> /dev/null) =~ ^[ZX] || ! $name =~ ^(${1-.*})$ ]] || echo "$pid $name"
    done
}
# The first of them, once there is one.
firstLeft() {
  local all
  waitLong someLeft "$1"
  all=$(left "$1")
  echo "${all%%[ $'\n']*}"
}
someLeft() { [[ $(left "$1") ]]; }
noneLeft() { [[ -z $(left "${1-.*}") ]]; }
# Waits for a command to succeed, and tells more than waitFor if it does not.
waitLong() { comesTrue "$@" || { tellMore; fail "waited in vain for: $*"; }; }
# Kills a process ($2) of a job of mpirun ($job) by a signal ($1). The job fails, and after 20 looks, a second of a machine with
# nothing else to do, nothing of it runs whose name matches $3; $4: what the process is. On a busy machine each look waits as
# those processes do.
expectAllEnd() {
  local began looks status=0
  began=$(milliseconds)
  kill -"$1" "$2"
  for ((looks = 0; looks < 20; ++looks)); do noneLeft "$3" && break; sleep 0.03; done
  noneLeft "$3" || fail "$4: something runs after $looks looks: $(left "$3")"
  echo "  $1 to $4: $(($(milliseconds) - began)) ms until nothing ran"
  wait "$job" || status=$?
  ((status)) || fail "$4: mpirun ended with 0"
  waitLong noneLeft 'mpirun|orted'
}
milliseconds() { echo $(($(date +%s%N) / 1000000)); }
# Whether a process ($1) listens on loopback only; $2: what it is.
expectLoopback() {
  local open
  open=$(ss -ltnHp | awk -v process="pid=$1," 'index($0, process) && $4 !~ /^(127\.|\[::1\])/ { print $4 }')
  [[ -z $open ]] || fail "$2 listens on $open"
}

# A Slurm with one node, this machine, for the user who runs it.
startSlurm() { # CPUs that it believes to have
  local user address
  address=$(getent ahostsv4 "$(hostname)" || true)
  [[ $address == 127.* ]] || skip "Slurm would listen at ${address%% *}, where this machine's name leads to"
  user=$(id -un)
  mkdir -p "$slurm"/{state,spool}
  (umask 077 && head -c 128 /dev/urandom > "$slurm/key")
  cat > "$slurm/slurm.conf" << END
ClusterName=test
SlurmctldHost=localhost(127.0.0.1)
SlurmUser=$user
SlurmdUser=$user
AuthType=auth/munge
CredType=cred/munge
# A job that is queued again waits until its old credential has expired.
AuthInfo=socket=$slurm/munge.socket,cred_expire=5
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
SlurmctldPort=$1
SlurmdPort=$(($1 + 1))
SlurmctldPidFile=$slurm/slurmctld.pid
SlurmdPidFile=$slurm/slurmd.pid
SlurmdSpoolDir=$slurm/spool
StateSaveLocation=$slurm/state
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SchedulerParameters=bf_interval=1,sched_interval=1
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
PreemptType=preempt/partition_prio
PreemptMode=REQUEUE
KillWait=2
MpiDefault=none
SlurmdParameters=config_overrides
NodeName=localhost NodeAddr=127.0.0.1 CPUs=4 RealMemory=500
PartitionName=low Nodes=localhost Default=YES PriorityTier=1 PreemptMode=REQUEUE
PartitionName=high Nodes=localhost PriorityTier=10 PreemptMode=OFF
END
  export SLURM_CONF=$slurm/slurm.conf PLUMBLINE_BIND=127.0.0.1
  # In sessions of their own: whoever ends the test by a signal to its group does not end them before their jobs.
  setsid munged --foreground --force --num-threads=2 --key-file="$slurm/key" --socket="$slurm/munge.socket" --seed-file="$slurm/seed" \
    --pid-file="$slurm/munged.pid" --log-file="$slurm/munged.log" > "$slurm/munged.out" 2>&1 &
  waitFor test -S "$slurm/munge.socket"
  (cd "$slurm" && exec setsid slurmctld -D > "$slurm/slurmctld.log" 2>&1) &
  (cd "$slurm" && exec setsid slurmd -D -N localhost > "$slurm/slurmd.log" 2>&1) &
  waitLong isIdle
}
isIdle() { [[ $(sinfo -h -o %T) == idle ]]; }
queueEmpty() { [[ -z $(squeue -h) ]]; }
stopSlurm() {
  timeout 5 scancel --user="$(id -un)" > /dev/null 2>&1 || true
  local i name
  for ((i = 0; i < 100; ++i)); do noneLeft 'slurmstepd|srun' && break; sleep 0.05; done
  for name in slurmd slurmctld munged; do
    left "$name" | while read -r i _; do kill "$i" 2> /dev/null || true; done
    for ((i = 0; i < 60; ++i)); do noneLeft "$name" && break; sleep 0.05; done
  done
}

# What there is to say where something goes wrong.
tellMore() {
  [[ ! -d $slurm ]] || { squeue || true; tail -n 15 "$slurm"/*.log || true; }
  tail -n 5 "$scratch"/*/*.log || true
} >&2

# At the end of every test, whether it passed, failed or was ended: nothing of it stays.
endOthers() {
  trap '' INT TERM HUP
  endMore
  [[ ! -d $slurm ]] || stopSlurm
  local pid
  left | while read -r pid _; do [[ $pid == "$$" ]] || kill "$pid" 2> /dev/null || true; done
  sleep 0.3
  left | while read -r pid _; do [[ $pid == "$$" ]] || kill -9 "$pid" 2> /dev/null || true; done
}
# What a test has to end besides; it defines it anew.
endMore() { :; }
