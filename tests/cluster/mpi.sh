# bin/mpitunnel with four ranks of Open MPI on this machine: a search, bytes of another program in both directions, a rank that is
# killed, mpirun that is ended or killed. Within a second nothing of it runs, and no port is open but on loopback.
source "$(dirname "${BASH_SOURCE[0]}")/cluster.bash"
needs mpirun ss perl
[[ -x $bin/mpitunnel ]] || skip "no $bin/mpitunnel: it was built where libopenmpi-dev was not installed"
tunnel=$bin/mpitunnel

echo "what it says of its command line"
expectError 2 "mpitunnel: the server's command is missing: -- SERVER -- WORKER; see mpitunnel --help" "$tunnel"
expectError 2 "mpitunnel: the worker's command is missing: -- SERVER -- WORKER; see mpitunnel --help" "$tunnel" -- true
expectError 2 "mpitunnel: the worker's command is missing: -- SERVER -- WORKER; see mpitunnel --help" "$tunnel" -- true --
"$tunnel" --help | grep -q "mpirun -n 4" || fail "no example in its help"
expectError 2 "mpi.sh: $scratch/none.yaml: no such study" scripts/cluster/mpi.sh run "$scratch/none.yaml" "$scratch/none"
expectError 2 'mpi.sh: RANKS is "1" and must be a number from 2 to 9999' scripts/cluster/mpi.sh submit "$scratch/none.yaml" "$scratch/none" 1
run() { timeout "$farOff" mpirun -n "$1" "$tunnel" "${@:2}" > "$scratch/run.out" 2> "$scratch/run.err"; }
status=0
run 1 -- true -- true || status=$?
expectEqual "$status" 2 "status of one rank alone"
grep -qx "mpitunnel: one rank alone has nobody to carry anything to: mpirun -n 2 or more" "$scratch/run.err" || fail "one rank: $(< "$scratch/run.err")"

echo "the server's status is the whole's"
for wanted in 0 7; do
  status=0
  run 3 --grace 0.1 -- sh -c "exit $wanted" -- sleep 3600 || status=$?
  expectEqual "$status" "$wanted" "status"
done
# Longer than any rank waits for MPI's farewell: who has ended its worker waits for the others.
run 3 --grace 7 -- sleep 0.3 -- sh -c '[ {rank} = 1 ] || sleep 3600' || fail "status $? where a worker ends late: $(< "$scratch/run.err")"
status=0
run 3 -- sleep 3600 -- no-such-command || status=$?
expectEqual "$status" 2 "status with a command that is not there"
grep -q "mpitunnel: rank [12]: cannot start no-such-command: No such file or directory" "$scratch/run.err" || fail "$(< "$scratch/run.err")"

echo "megabytes in both directions, each end of a connection by itself"
cat > "$scratch/server.pl" << 'END'
use strict; use IO::Socket::INET; use Digest::MD5 qw(md5_hex);
# Takes all of each client until it ends its way, then sends twice as much back; after so many clients it ends.
my $listener = IO::Socket::INET->new(LocalAddr => "127.0.0.1", LocalPort => $ARGV[0], Listen => 10, ReuseAddr => 1) or die "port: $!";
my @children;
for (1 .. $ARGV[1]) {
  my $client = $listener->accept;
  my $child = fork;
  if ($child) { push @children, $child; next; }
  local $/; my $all = <$client>;
  print $client $all, $all; close $client; exit 0;
}
waitpid $_, 0 for @children;
END
cat > "$scratch/client.pl" << 'END'
use strict; use IO::Socket::INET; use Digest::MD5 qw(md5_hex);
my ($port, $number) = @ARGV;
my $server = IO::Socket::INET->new("127.0.0.1:$port") or die "connect: $!";
srand $number; my $bytes = join "", map { pack "N", int rand 4294967295 } 1 .. 1_500_000;
print $server $bytes; shutdown $server, 1;
local $/; my $back = <$server>;
die "got " . length($back) . " bytes of another kind\n" if md5_hex($back) ne md5_hex($bytes . $bytes);
print "client $number is content\n";
END
began=$(milliseconds)
run 4 -- perl "$scratch/server.pl" {port} 6 -- sh -c "perl $scratch/client.pl {port} {rank} & perl $scratch/client.pl {port} 1{rank}; wait" ||
  fail "status $?: $(< "$scratch/run.err")"
expectEqual "$(sort "$scratch/run.out" | tr '\n' ',')" "$(printf 'client %s is content,' 1 11 12 13 2 3)" "what six clients say"
echo "  108 MB in $(($(milliseconds) - began)) ms"

echo "a search with three workers, one of which is killed"
writeStudy 0.02 30
scripts/cluster/mpi.sh run "$scratch/study.yaml" "$scratch/farm" -n 4 > "$scratch/farm.out" 2>&1 & job=$!
waitLong hasResults "$scratch/farm" 30
expectEqual "$(stat -c %a "$scratch/farm/token")" 600 "who may read the token"
for name in mpitunnel optserver optworker; do
  mapfile -t pids < <(left "$name")
  ((${#pids[@]})) || fail "there is no $name"
  for pid in "${pids[@]}"; do expectLoopback "${pid%% *}" "$name"; done
done
kill -9 "$(firstLeft optworker)"
wait "$job" || fail "the job ended with $?: $(tail -5 "$scratch/farm.out")"
expectAsAlone "$scratch/farm"
grep -q "mpitunnel: rank [123]: .*/optworker ended with status 137, and is started again" "$scratch/farm.out" || fail "nothing is said of the killed worker"
expectEqual "$(sed 1d "$scratch/farm/evaluations.jsonl" | grep -o '"worker":"[^"]*"' | sort -u | wc -l)" 4 "workers that took part"

# The pid of a rank ($1) of the job ($2).
rankOf() {
  local pid
  for pid in $(left mpitunnel | sed 's/ .*//'); do
    tr '\0' '\n' < "/proc/$pid/environ" | grep -qx "OMPI_COMM_WORLD_RANK=$1" && [[ $(ps -o ppid= -p "$pid") -eq $2 ]] && echo "$pid"
  done
  return 0
}
writeStudy 0.05 30
rm -rf "$scratch/farm"
echo "a job that is suspended goes on when it is continued"
mpirun -n 3 "$tunnel" -- "$bin/optserver" "$scratch/study.yaml" --folder "$scratch/farm" --port {port} -- \
  "$bin/optworker" --port {port} > "$scratch/paused.out" 2>&1 & job=$!
waitLong hasResults "$scratch/farm" 15
ranks=$(left mpitunnel | sed 's/ .*//')
for ((i = 0; i < 3; ++i)); do
  kill -STOP $ranks
  sleep 0.3
  kill -CONT $ranks
  waitLong hasResults "$scratch/farm" $(($(results "$scratch/farm") + 5))
done
kill -0 $ranks || fail "a rank has ended: $(< "$scratch/paused.out")"
kill -TERM "$job"
wait "$job" || true
waitLong noneLeft 'mpi.*|opt.*'
# What is started by a worker's command itself has to end too.
for victim in "KILL rank 2" "KILL rank 0" "TERM rank 1" "TERM mpirun" "INT mpirun" "KILL mpirun"; do
  read -r signal what number <<< "$victim"
  before=$(results "$scratch/farm")
  setsid mpirun -n 4 "$tunnel" -- "$bin/optserver" "$scratch/study.yaml" --folder "$scratch/farm" --port {port} -- \
    sh -c "sleep 3600 & $bin/optworker --port {port}; wait" > "$scratch/killed.out" 2>&1 & job=$!
  waitLong hasResults "$scratch/farm" $((before + 15))
  main=$(left mpirun | sed 's/ .*//')
  pid=$main
  [[ $what == mpirun ]] || pid=$(rankOf "$number" "$main")
  [[ $pid ]] || fail "there is no $what $number"
  expectAllEnd "$signal" "$pid" 'mpitunnel|optserver|optworker|sleep|sh' "$what $number"
done
echo "and the search goes on to the same end"
scripts/cluster/mpi.sh run "$scratch/study.yaml" "$scratch/farm" -n 3 > "$scratch/farm.out" 2>&1 || fail "status $?: $(tail -5 "$scratch/farm.out")"
expectAsAlone "$scratch/farm"
