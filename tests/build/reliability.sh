#!/usr/bin/env bash
# What a soak's samples come to, and which rows of the page's tables a later run of some jobs replaces.
source "$(dirname "$0")/project.bash"
writeSources

# Samples of two agents, 30 s each: the cost of a cycle and the same of a new game, of which a busy machine makes more.
samples() { # growth of a cycle's cost in the second half [%], noise [%]
  awk -v growth="$1" -v noise="$2" 'BEGIN {
    print "time,simulator_kb,agents_kb,simulator_us,agents_us,simulator_allocated_kb,agents_allocated_kb,new_simulator_us,new_agents_us"
    for (i = 1; i <= 60; ++i) {
      load = i <= 40 ? 1 : 1.4
      more = (1 + (i > 40) * growth / 100) * (1 + (i * 7 % 11 - 5) * noise / 500)
      s += 1500 * 250 * load * more; a += 1500 * 600 * load * more
      printf "%d,1000,2000,%.0f,%.0f,1,1,%.2f,%.2f\n", 30 * i, s, a, 260 * load, 640 * load
    }
  }'
}
judge() { text=$(awk -F, -v limit=1024 -v percent=2 -v number=2 -v alive="${1:-2}" -f scripts/soak.awk samples.csv); }
samples 0 1 > samples.csv
judge
expect "a busy machine: status" $? 0
contains "a busy machine" "$text" "CPU per cycle simulator 250 then 350 us, an agent 300 then 420 us"
contains "a busy machine" "$text" ": below 2 %, agents "
contains "a busy machine" "$text" ": below 2 %; 2 agents at the end"
samples 5 1 > samples.csv
judge
expect "a cycle that costs 5 % more: status" $? 1
contains "a cycle that costs 5 % more" "$text" ": more than 2 %; 2 agents"
samples 0 20 > samples.csv
judge
expect "games that differ: status" $? 0
contains "games that differ" "$text" ": not decided"
judge 1
expect "a lost agent: status" $? 1
sed -i '30,$s/,1000,2000,/,3000,2000,/' samples.csv
judge
expect "memory that grows: status" $? 1

# The page keeps the rows of jobs that a run leaves out.
mkdir -p doc/results build/{faults,fuzz,soak} tests/fuzz
touch tests/fuzz/Readers.cpp
cat > doc/results/reliability.md << 'END'
<!-- measured -->

## Readers under libFuzzer

`make fuzz`, 2026-01-01:

| target | executions | branches | seconds | result |
|---|---|---|---|---|
| agent | 100 | 20 | 20 | nothing |
| json | 200 | 30 | 20 | nothing |

300 executions, 0 of 2 targets broke.

## Calls of the system that fail

`make faults`, 2026-01-01:

| job | write | sync | rename | open | malloc | places | broken |
|---|---|---|---|---|---|---|---|
| first | 4 | 3 | 2 | 3 | 100 | 100 | 0 |
| second | 2 | 2 | 1 | 1 | 50 | 50 | 0 |

168 faults in 2 jobs, 0 broke something.

## Long games

`make soak`, 2026-01-01, 2 cores: 1 agents, 1439 simulated minutes: as before.

`make soak`, 2026-01-01, 2 cores: 22 agents, 12 simulated minutes: as before.

<!-- /measured -->
END
printf 'job write sync rename open malloc places broken\nsecond 2 2 1 1 60 60 1\nthird 0 0 0 0 7 7 0\n73 faults in 2 jobs, 1 broke something\n' > build/faults/table.txt
printf 'target executions branches seconds result\njson 900 40 60 nothing found\n900 executions, 0 of 1 targets broke\n' > build/fuzz/table.txt
echo "22 agents, 90 simulated minutes: as now" > build/soak/22.txt
scripts/make_reliability.sh > /dev/null || fail "no page"
page=$(< doc/results/reliability.md)
contains "other jobs" "$page" '| first | 4 | 3 | 2 | 3 | 100 | 100 | 0 |
| second | 2 | 2 | 1 | 1 | 60 | 60 | 1 |
| third | 0 | 0 | 0 | 0 | 7 | 7 | 0 |

185 faults in 3 jobs, 1 broke something. Of this run: second, third.'
contains "other targets" "$page" '| agent | 100 | 20 | 20 | nothing |
| json | 900 | 40 | 60 | nothing |

1000 executions, 0 of 2 targets broke. Of this run: json.'
contains "a longer game of other agents" "$page" "1 agents, 1439 simulated minutes: as before."
contains "a new game of as many agents" "$page" "22 agents, 90 simulated minutes: as now."
lacks "a new game of as many agents" "$page" "12 simulated minutes"
finish
