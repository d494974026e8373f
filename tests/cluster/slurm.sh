# A search as jobs of a real Slurm, on one node: preempted, queued again and killed in the midst it finds what it finds alone. So
# does the same search as one job of Open MPI.
source "$(dirname "${BASH_SOURCE[0]}")/cluster.bash"
needs munged slurmctld slurmd sbatch srun scontrol
search=scripts/cluster/search.sh folder=$scratch/farm
writeStudy 0.08 45
startSlurm "$((20000 + RANDOM % 10000))"

"$search" submit "$scratch/study.yaml" "$folder" 3 > "$scratch/submitted"
expectEqual "$(sed 's/[0-9][0-9]*/N/g' "$scratch/submitted")" "server N, workers N; how far it is: tail -f $(sed 's/[0-9][0-9]*/N/g' <<< "$folder")/server.log" "what submit says"
read -r server workers < <(sed 's/server \([0-9]*\), workers \([0-9]*\);.*/\1 \2/' "$scratch/submitted")
hasFailed() { [[ $(stateOf "$server") == "FAILED " ]]; }
stateOf() { scontrol -o show job "$1" | sed 's/.*JobState=\([A-Z]*\).*/\1/' | sort -u | tr '\n' ' '; }
restarts() { scontrol -o show job "$1" | sed -n 's/.*Restarts=\([0-9]*\).*/\1/p' | awk '{ sum += $1 } END { print sum + 0 }'; }
waitLong hasResults "$folder" 30
for name in munged slurmctld slurmd optserver optworker srun slurmstepd; do
  mapfile -t pids < <(left "$name")
  ((${#pids[@]})) || fail "there is no $name"
  for pid in "${pids[@]}"; do expectLoopback "${pid%% *}" "$name"; done
done

echo "a job of a higher priority takes the whole node"
high=$(sbatch --parsable --partition=high --exclusive --output="$scratch/high.log" --wrap "sleep 1; squeue -h -t running -o %P")
waitLong test -s "$scratch/high.log"
expectEqual "$(< "$scratch/high.log")" high "what runs beside it"
before=$(results "$folder")
[[ $(stateOf "$server") == PENDING* ]] || fail "the preempted server is $(stateOf "$server")"
waitLong hasResults "$folder" $((before + 20))
grep -q "continues from" "$folder/server.log" || fail "the server began anew"
expectEqual "$(stateOf "$high")" "COMPLETED " "the job of a higher priority"

echo "server and a worker are queued again by hand"
scontrol requeue "$server"
scontrol requeue "${workers}_2"
before=$(results "$folder")
waitLong hasResults "$folder" $((before + 20))

echo "Slurm ends the job of a worker"
hasEnded() { [[ -z $(squeue -h -j "$1") ]]; }
scancel "${workers}_3"
waitLong hasEnded "${workers}_3"
before=$(results "$folder")
waitLong hasResults "$folder" $((before + 20))

echo "a worker and the server are killed"
for name in optworker optserver; do
  kill -9 "$(firstLeft "$name")"
  before=$(results "$folder")
  if [[ $name == optserver ]]; then
    # Its job has failed, as any job whose program does: the same command goes on with it.
    waitLong hasFailed
    scontrol requeue "$server"
  fi
  waitLong hasResults "$folder" $((before + 10))
done

waitLong test -f "$folder/over"
waitLong queueEmpty
expectAsAlone "$folder"
grep -q "over (maxGenerations)" "$folder/server.log" || fail "the search did not end"
echo "all was $(restarts "$server") + $(restarts "$workers") times queued again"
(($(restarts "$server") >= 3)) || fail "the server was queued again $(restarts "$server") times only"

if [[ -x $bin/mpitunnel ]] && command -v mpirun > /dev/null; then
  echo "the same as one job of Open MPI"
  scripts/cluster/mpi.sh submit "$scratch/study.yaml" "$scratch/mpi" 4 > "$scratch/submitted"
  job=$(sed 's/job \([0-9]*\);.*/\1/' "$scratch/submitted")
  waitLong hasResults "$scratch/mpi" 30
  scontrol requeue "$job"
  waitLong hasResults "$scratch/mpi" 80
  waitLong queueEmpty
  expectAsAlone "$scratch/mpi"
  expectEqual "$(restarts "$job")" 1 "how often it was queued again"
fi

stopSlurm
noneLeft 'munged|slurm.*|srun|opt.*|mpi.*' || fail "still there: $(left 'munged|slurm.*|srun|opt.*|mpi.*')"
