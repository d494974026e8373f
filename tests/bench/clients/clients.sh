#!/usr/bin/env bash
# Table 3.6 and figure 3.26 of the thesis (Seekircher 2015): the same 990 evaluations by more and more real workers, whose
# evaluations sleep, and how much sooner they are done. Table 3.7: the share of that time for which the server computes (updates of
# the optimiser, messages, files). Then real simulators, as many as there are cores. Writes build/bench/clients.json, .md and .svg.
# SECONDS of an evaluation: SLEEP [0.1].
set -euo pipefail
sleep=${SLEEP-0.1} ticks=$(getconf CLK_TCK)
scratch=$(mktemp -d) server="" each="" share="" speedup="" rows="" shares="" real=""
trap '[[ -z $server ]] || kill "$server" 2> /dev/null || true; rm -rf "$scratch"' EXIT
lines=() load=$(cut -d' ' -f1 /proc/loadavg) # other work makes all of this slower
row() { # OPTIMISER WORKERS; prints "milliseconds | times as fast | efficiency"
  awk -v o="$1" -v n="$2" -v e="$each" -v s="$speedup" 'BEGIN { printf "| %s | %d | %.2f | %.3f | %.0f", o, n, 1000 * e, s, 100 * s / n }'
}
figure() { lines+=("{\"name\": \"clients.$1\", \"value\": $2, \"unit\": \"$3\", \"better\": \"$4\"${5-}}"); }

# Processor seconds that the server has used; nothing where it has ended.
computed() { awk -v t="$ticks" '{ sub(/.*\) /, ""); print ($12 + $13) / t }' "/proc/$server/stat" 2> /dev/null; }

# Plays the study $1 with $2 workers. From the moment at which all are there: seconds per evaluation that was left ($each), and
# the share of them for which the server computed ($share) [%].
play() {
  local folder=$scratch/$1-$2 before begin end first last now
  bin/optserver "$scratch/$1.yaml" --folder "$folder" --workers "$2" --port 0 --every 1000 > "$folder.out" 2>&1 &
  server=$!
  until [[ -s $folder/port ]]; do sleep 0.02; done
  until bin/optserver --status --port "$(< "$folder/port")" 2> /dev/null | grep -q "\"workers\":$2[,}]"; do
    kill -0 "$server" || { echo "clients.sh: the search ended before all workers were there" >&2; exit 1; }
    sleep 0.05
  done
  first=$(computed) last=$first begin=$(date +%s.%N) before=$(wc -l < "$folder/evaluations.jsonl")
  while now=$(computed) && [[ $now ]]; do last=$now; sleep 0.05; done
  wait "$server" || { echo "clients.sh: the server ended with $?" >&2; cat "$folder.out" >&2; exit 1; }
  server="" end=$(date +%s.%N)
  read -r each share < <(awk -v b="$begin" -v e="$end" -v n="$(($(wc -l < "$folder/evaluations.jsonl") - before))" \
    -v c="$last" -v f="$first" 'BEGIN { printf "%.6f %.4f\n", (e - b) / n, 100 * (c - f) / (e - b) }')
}

declare -A thesis=([pso30]=26.398 [cmaes30]=26.269 [xnes30]=4.332 [pso20]=14.157 [cmaes20]=14.486 [xnes20]=3.779
  [pso10]=8.790 [cmaes10]=8.306 [xnes10]=3.396 [pso1]=1 [cmaes1]=1 [xnes1]=1)
declare -A phase=([pso1]=0.0126 [pso10]=0.1048 [pso20]=0.1538 [cmaes1]=0.0937 [cmaes10]=0.9119 [cmaes20]=1.3799
  [xnes1]=13.8059 [xnes10]=61.4714 [xnes20]=71.2221)
: > "$scratch/drawn.tsv"
# A search of the thesis's leg motion has 96 parameters. "ahead": with three generations of ten at a time, which 20 workers share
# better than one of 30.
for optimizer in pso cmaes xnes ahead; do
  population=30 ahead=1
  [[ $optimizer != ahead ]] || population=10 ahead=3
  cat > "$scratch/$optimizer.yaml" << END
task: function
options: {function: sphere, dimension: 96, sleep: $sleep, spread: 0.02}
optimizer: ${optimizer/#ahead/cmaes}
population: $population
ahead: $ahead
runs: 1
sameSeeds: false
evaluations: 990
END
  one=""
  for clients in 1 5 10 15 20 25 30; do
    play "$optimizer" "$clients"
    [[ $one ]] || one=$each
    speedup=$(awk -v a="$one" -v b="$each" 'BEGIN { printf "%.3f", a / b }')
    echo "$optimizer, $clients workers: $speedup times as fast as one, the server computes $share % of the time"
    key=$optimizer$clients
    rows+="$(row "$optimizer" "$clients") | ${thesis[$key]-} |"$'\n'
    shares+="| $optimizer | $clients | $share | ${phase[$key]-} |"$'\n'
    printf '%s\t%s\t%s\n' "$optimizer" "$clients" "$speedup" >> "$scratch/drawn.tsv"
    ((clients == 1)) || figure "$optimizer.speed_up_of_$clients" "$speedup" "" higher \
      "${thesis[$key]:+, \"peer\": \"thesis, table 3.6\", \"peer_value\": ${thesis[$key]-}}"
    figure "$optimizer.server_computes_with_$clients" "$share" % lower \
      "${phase[$key]:+, \"peer\": \"thesis, table 3.7, updates alone\", \"peer_value\": ${phase[$key]-}}"
  done
done

cat > "$scratch/real.yaml" << END
task: standUp
options: {type: 0, direction: front}
optimizer: cmaes
population: 30
runs: 2
evaluations: 600
END
one=""
for ((clients = 1; clients <= $(nproc); clients *= 2)); do
  play real "$clients"
  [[ $one ]] || one=$each
  speedup=$(awk -v a="$one" -v b="$each" 'BEGIN { printf "%.3f", a / b }')
  echo "stand-up in real simulators, $clients workers: $speedup times as fast as one, the server computes $share % of the time"
  real+="$(row "stand-up" "$clients") | $share |"$'\n'
  ((clients == 1)) || figure "stand_up.speed_up_of_$clients" "$speedup" "" higher
  figure "stand_up.server_computes_with_$clients" "$share" % lower
done
mkdir -p build/bench
for key in pso cmaes xnes; do
  for clients in 1 10 20 30; do printf 'thesis, %s\t%s\t%s\n' "$key" "$clients" "${thesis[$key$clients]}"; done
done >> "$scratch/drawn.tsv"
awk -v title="Speed-up by the number of clients (thesis, figure 3.26)" -v xLabel="clients" -v yLabel="times as fast as one client" \
  -f tests/support/diagram.awk "$scratch/drawn.tsv" > build/bench/clients.svg
{
  echo "## Table 3.6 and figure 3.26 of the thesis"
  echo
  echo "The same 990 evaluations of $sleep s, 2 % deviation, in 96 dimensions, by real workers (bin/optworker) of a real server (bin/optserver),"
  echo "and how many times as fast as one worker they are, beside the thesis's setup 3 (leg motion). One search each, optimiser's seed 1, timed from the"
  echo "moment at which all workers are there. Efficiency: that, divided by the number of workers. A population of 30 by 15 to 29 workers takes"
  echo "two rounds: at most 15 times as fast. ahead: CMA-ES with three generations of ten under way at a time. When this began the machine had a load"
  echo "average of $load by other work."
  printf '\n| optimiser | workers | ms per evaluation | times as fast | efficiency [%%] | thesis, times as fast |\n|---|---|---|---|---|---|\n%s' "$rows"
  printf '\n![Speed-up by the number of clients](clients.svg)\n\n## Table 3.7 of the thesis\n\n'
  echo "Processor time of the server's process (optimiser, messages, files), in per cent of the time from begin to end, beside the share of the update"
  echo "phase alone in the thesis, whose evaluations took about 0.4 s."
  printf '\n| optimiser | workers | server computes [%%] | thesis, update phase [%%] |\n|---|---|---|---|\n%s' "$shares"
  printf '\n## Real simulators\n\nA search of the stand-up from the front (type 0, 600 trials of two runs at most) by as many workers as there are cores.\n'
  printf '\n| task | workers | ms per trial | times as fast | efficiency [%%] | server computes [%%] |\n|---|---|---|---|---|---|\n%s' "$real"
} > build/bench/clients.md
(IFS=,; printf '[%s]\n' "${lines[*]}") | sed 's/},{/},\n {/g' > build/bench/clients.json.new
mv build/bench/clients.json.new build/bench/clients.json
