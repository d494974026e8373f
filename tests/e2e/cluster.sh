# A search as Slurm jobs, with an sbatch and an srun that start the jobs here: the real server and the real workers. The server
# and a worker are preempted in the midst and queued again; what is found is what is found without a cluster.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
mkdir "$scratch/fake"
: > "$scratch/groups"
endOthers() { local group; while read -r group; do kill -9 -- "-$group" 2> /dev/null || true; done < "$scratch/groups"; }
# Each job is a group of processes of its own, written down with its number and command: whoever queues it again has both.
cat > "$scratch/fake/start" << 'END'
#!/usr/bin/env bash
out=$1
shift
setsid "$@" >> "$out" 2>&1 < /dev/null &
echo $! >> "$FAKE/groups"
END
cat > "$scratch/fake/sbatch" << 'END'
#!/usr/bin/env bash
count=0 out=/dev/null
while [[ $1 == --* ]]; do
  case $1 in
    --array=1-*) count=${1#--array=1-} ;;
    --output=*) out=${1#--output=} ;;
  esac
  echo "$1" >> "$FAKE/options"
  shift
done
if ((count)); then
  for ((i = 1; i <= count; ++i)); do SLURM_ARRAY_TASK_ID=$i "$FAKE/fake/start" "${out//%a/$i}" "$@"; done
  echo 43
else
  "$FAKE/fake/start" "$out" "$@"
  echo "42;here"
fi
END
cat > "$scratch/fake/srun" << 'END'
#!/usr/bin/env bash
while [[ $1 == --* ]]; do shift; done
exec "$@"
END
chmod +x "$scratch"/fake/*
export FAKE=$scratch PATH=$scratch/fake:$PATH SLURMD_NODENAME=localhost PLUMBLINE_WAIT=300
search=scripts/cluster/search.sh

cat > "$scratch/study.yaml" << END
task: function
options: {function: rosenbrock, dimension: 4, sleep: 0.08, spread: 0.3}
population: 8
ahead: 3
runs: 1
runsOfBest: 2
generations: 25
END
"$bin/optserver" "$scratch/study.yaml" --folder "$scratch/alone" --workers 4 --port 0 > "$scratch/alone.out"

expectEqual "$("$search" submit "$scratch/study.yaml" "$scratch/farm" 2 --partition=short)" \
  "server 42, workers 43; how far it is: tail -f $scratch/farm/server.log" "what submit says"
expectEqual "$(stat -c %a "$scratch/farm/token")" 600 "who may read the token"
grep -qx -e --partition=short "$scratch/options" || fail "an option was not passed on"
grep -qx -e --dependency=after:42 "$scratch/options" || fail "the workers do not wait for the server"
expectEqual "$(grep -cx -e --requeue "$scratch/options")" 2 "jobs that are queued again"

lines() { wc -l < "$scratch/farm/evaluations.jsonl" 2> /dev/null || echo 0; }
# Until so many results, or what is asked, however busy the machine is.
until_() { comesTrue "$@" && return 0; fail "waited in vain for: $*: $(tail -3 "$scratch"/farm/*.log)"; }
atLeast() { (($(lines) >= $1)); }
until_ atLeast 40
# Preempted: the server and one worker, each with its whole job; both come back, the server at another port.
{ read -r server; read -r worker; } < "$scratch/groups"
kill -9 -- "-$server" "-$worker"
"$scratch/fake/start" "$scratch/farm/server.log" "$search" server "$scratch/study.yaml" "$scratch/farm"
"$scratch/fake/start" "$scratch/farm/worker-1.log" "$search" worker "$scratch/farm"
until_ test -f "$scratch/farm/over"
grep -q "continues from" "$scratch/farm/server.log" || fail "it started again from the beginning"
grep -q "over (maxGenerations)" "$scratch/farm/server.log" || fail "the search did not end"
cmp <(grep -v '^#' "$scratch/alone/found.yaml") <(grep -v '^#' "$scratch/farm/found.yaml") || fail "the farm found something else"
expectEqual "$(sed 1d "$scratch/farm/evaluations.jsonl" | sed 's/.*"trial":\([0-9]*\).*/\1/' | sort | uniq -d | wc -l)" 0 "trials counted twice"
# All jobs end by themselves once it is over.
ended() { local group; while read -r group; do ! kill -0 -- "-$group" 2> /dev/null || return 1; done < "$scratch/groups"; }
until_ ended

expectError 2 "search.sh: WORKERS is \"many\" and must be a number from 1 to 9999" "$search" submit "$scratch/study.yaml" "$scratch/other" many
expectError 2 "search.sh: $scratch/none.yaml: no such study" "$search" submit "$scratch/none.yaml" "$scratch/other" 3
