# Ranks on nodes of their own: network namespaces on one bridge, each with a loopback that no other one sees. A search through
# bin/mpitunnel finds what it finds alone, by the network of MPI alone; when a node's rank is killed nothing runs a second later.
source "$(dirname "${BASH_SOURCE[0]}")/cluster.bash"
needs mpirun ip ss
[[ -x $bin/mpitunnel ]] || skip "no $bin/mpitunnel: it was built where libopenmpi-dev was not installed"
((EUID == 0)) || skip "only root may make network namespaces"
name=plumbline$$
ip netns add "$name-hub" 2> /dev/null || skip "network namespaces are not allowed here"
endMore() {
  local space pid
  for space in $(ip netns list | sed -n "s/^\($name-[a-z0-9]*\).*/\1/p"); do
    for pid in $(ip netns pids "$space"); do kill -9 "$pid" 2> /dev/null || true; done
    ip netns del "$space" || true
  done
}

# Three nodes; the hub has the bridge and is no node.
ip -n "$name-hub" link add bridge type bridge 2> /dev/null || skip "this kernel has no bridges"
ip -n "$name-hub" link set bridge up
for node in 1 2 3; do
  ip netns add "$name-$node"
  ip -n "$name-hub" link add "port$node" type veth peer name mpi netns "$name-$node"
  ip -n "$name-hub" link set "port$node" master bridge up
  ip -n "$name-$node" link set lo up
  ip -n "$name-$node" address add "10.77.0.$node/24" dev mpi
  ip -n "$name-$node" link set mpi up
done
pidsOn() { local pid; for pid in $(ip netns pids "$name-$1"); do [[ $(cat "/proc/$pid/comm") != "$2" ]] || echo "$pid"; done; }
on() { ip netns exec "$name-$1" "${@:2}"; }
waitFor on 1 bash -c '</dev/tcp/10.77.0.2/9 || [[ $? == 1 ]]'

# What ssh is to a cluster: HOST COMMAND..., with a name of the node's own, by which Open MPI tells nodes.
cat > "$scratch/agent" << END
#!/usr/bin/env bash
node=\${1##*.}
shift
exec ip netns exec $name-\$node unshare --uts bash -c 'hostname node\$0 && exec bash -c "\$1"' "\$node" "\$*"
END
chmod +x "$scratch/agent"
printf '10.77.0.%d slots=%d\n' 1 1 2 2 3 1 > "$scratch/hosts"
export OMPI_MCA_plm_rsh_agent=$scratch/agent OMPI_MCA_btl=self,vader,tcp OMPI_MCA_orte_keep_fqdn_hostnames=1
export OMPI_MCA_btl_tcp_if_include=10.77.0.0/24 OMPI_MCA_oob_tcp_if_include=10.77.0.0/24
here() { ip netns exec "$name-1" unshare --uts bash -c 'hostname node1 && exec "$0" "$@"' "$@"; }

writeStudy 0.02 30
echo "four ranks on three nodes"
here scripts/cluster/mpi.sh run "$scratch/study.yaml" "$scratch/farm" -n 4 --hostfile "$scratch/hosts" > "$scratch/farm.out" 2>&1 & job=$!
waitLong hasResults "$scratch/farm" 30
for node in 1 2 3; do
  open=$(on "$node" ss -ltnHp | awk '/"(optserver|optworker)"/ && $4 !~ /^127\./')
  [[ -z $open ]] || fail "node $node: a port is open: $open"
  expectEqual "$(pidsOn "$node" optworker | wc -l)" "$((node == 2 ? 2 : node == 3))" "workers of node $node"
done
wait "$job" || fail "the job ended with $?: $(tail -5 "$scratch/farm.out")"
expectAsAlone "$scratch/farm"
expectEqual "$(sed 1d "$scratch/farm/evaluations.jsonl" | grep -o '"worker":"[^"]*"' | sed 's/-[0-9]*"$//' | sort -u | tr '\n' ' ')" \
  '"worker":"node2 "worker":"node3 ' "where it was evaluated"

echo "the rank of another node is killed"
writeStudy 0.05 200
here scripts/cluster/mpi.sh run "$scratch/study.yaml" "$scratch/killed" -n 4 --hostfile "$scratch/hosts" > "$scratch/killed.out" 2>&1 & job=$!
waitLong hasResults "$scratch/killed" 20
expectAllEnd KILL "$(pidsOn 3 mpitunnel)" 'mpitunnel|optserver|optworker' "the rank of node 3"
