# bin/mpitunnel, where Open MPI is installed: each rank in a job of its own, the other one without faults. Sourced by jobs.bash.
# The server sends a line to the worker's connection, and ends when it has the answer.
mpiRanks() { # rank that has the faults
  local whole=(env -u LD_PRELOAD -u FAULT) ranks=() rank
  for rank in 0 1; do
    ((rank == 0)) || ranks+=(:)
    ranks+=(-n 1)
    ((rank == $1)) || ranks+=("${whole[@]}")
    ranks+=("$bin/mpitunnel" --grace 0.1 --silence 2 -- perl server.pl "{port}" -- perl client.pl "{port}")
  done
  # Without memory, Open MPI's own libraries die: they are not tried.
  FAULT_LEAVES_OUT=openmpi:pmix:libmpi:libopen-:libevent:libhwloc:libuc:libfabric OMPI_ALLOW_RUN_AS_ROOT=1 \
    OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 mpirun --oversubscribe "${ranks[@]}"
}
mpiPrepare() {
  cat > server.pl << 'END'
use strict; use IO::Socket::INET;
my $listener = IO::Socket::INET->new(LocalAddr => "127.0.0.1", LocalPort => $ARGV[0], Listen => 1, ReuseAddr => 1) or die "port: $!";
my $client = $listener->accept;
print $client "question\n";
exit(<$client> eq "answer\n" ? 0 : 3);
END
  cat > client.pl << 'END'
use strict; use IO::Socket::INET;
my $server = IO::Socket::INET->new("127.0.0.1:$ARGV[0]") or die "connect: $!";
print $server "answer\n" if <$server> eq "question\n";
<$server>;
END
}
[[ ! -x $bin/mpitunnel ]] || ! command -v mpirun > /dev/null || { job mpitunnel_server mpitunnel; job mpitunnel_worker mpitunnel; }
mpitunnel_server_prepare() { mpiPrepare; }
mpitunnel_server_run() { mpiRanks 0; }
mpitunnel_worker_prepare() { mpiPrepare; }
mpitunnel_worker_run() { mpiRanks 1; }
