#!/usr/bin/env bash
# Head to head on recordings of real robots: bin/gap diagnose by blocks and by sets on the same recordings, and what
# bin/gap check measures of each answer on recordings of other motions. Writes build/bench/gap-peers.json and .md.
# The recordings are not part of the project. Environment:
#   DATA     their folder [../shared/gap/real]
#   SPLIT    one split alone: xl330.kp100, xl330.kp200, xl330.kp800, so101
#   METHODS  [blocks sets]
# A piece that is in build/gap-peers is taken as it is, so a run that was stopped goes on.
set -euo pipefail
data=${DATA:-../shared/gap/real} kept=build/gap-peers
[[ -d $data ]] || { echo "bench gap-peers: $data is not there: make bench-gap-peers DATA=FOLDER" >&2; exit 2; }
mkdir -p "$kept" build/bench
# name, robot, folder, motions for fitting, motions for testing
splits=(
  "xl330.kp100|xl330_pendulum|xl330_pendulum|kp100_sin_sin kp100_up_and_down|kp100_lift_and_drop kp100_sin_time_square"
  "xl330.kp200|xl330_pendulum|xl330_pendulum|kp200_sin_sin kp200_up_and_down|kp200_lift_and_drop kp200_sin_time_square"
  "xl330.kp800|xl330_pendulum|xl330_pendulum|kp800_sin_sin kp800_up_and_down|kp800_lift_and_drop kp800_sin_time_square"
  "so101|so101|so101|actuator_bandwidth friction_gravity multisine step_response|chirp_sweep custom_motion end_effector frequency_sweep trapezoidal_profile backlash_detection"
)
done=()
for split in "${splits[@]}"; do
  IFS='|' read -r name robot folder fit tests <<< "$split"
  for method in ${METHODS:-blocks sets}; do
    piece=$kept/$name.$method
    if [[ ! -s $piece.check.json && (${SPLIT:-$name} == "$name") ]]; then
      bin/gap diagnose $(printf "$data/$folder/%s " $fit) --method $method --robot $robot --seconds 20 --json "$piece.json" \
        --timing "$piece.timing.json"
      bin/gap check "$piece.json" $(printf "$data/$folder/%s " $tests) --robot $robot --json "$piece.check.json"
    fi
    [[ ! -s $piece.check.json ]] || done+=("$piece")
  done
done
node - "${done[@]}" << 'E2'
const fs = require('fs'), path = require('path');
const read = (file) => JSON.parse(fs.readFileSync(file)), percent = (x) => `${Math.round(100 * x)} %`;
let page = `Each answer saw the recordings for fitting alone; \`bin/gap check\` then replays recordings of other motions, free
from their first sample. Claimed: what the answer says of a recording that it did not see (of blocks: of half-seconds of the
same recordings). Measured: the mean of what it closed. Nothing that was left is taken as a floor: there is no repeat.

| robot | method | causes | claimed | 90 % of it | measured | per recording | CPU s |
|---|---|---|---|---|---|---|---|
`;
const figures = [];
for (const piece of process.argv.slice(2)) {
  const name = path.basename(piece), method = name.slice(name.lastIndexOf('.') + 1), robot = name.slice(0, -method.length - 1);
  const answer = read(`${piece}.json`), check = read(`${piece}.check.json`), timing = read(`${piece}.timing.json`);
  const range = check.claimed_interval ? `${percent(check.claimed_interval[0])} to ${percent(check.claimed_interval[1])}` : '';
  const causes = answer.effects.map((e) => `${e.effect} at ${e.at} ${e.value.toPrecision(3)} (${e.probability.toFixed(2)})`).join(', ');
  page += `| ${robot} | ${method} | ${causes || 'none'} | ${percent(check.claimed)} | ${range} | ${percent(check.closed)} | ` +
    `${check.runs.map((r) => `${path.basename(r.folder)} ${percent(r.closed)}`).join(', ')} | ${Math.round(timing.cpu_seconds)} |\n`;
  figures.push({ name: `gap-peers.closed.${robot}.${method}`, value: check.closed, unit: '1', better: 'higher' },
    { name: `gap-peers.claim-off.${robot}.${method}`, value: Math.abs(check.claimed - check.closed), unit: '1', better: 'lower', target: 0.1 },
    { name: `gap-peers.cpu.${robot}.${method}`, value: timing.cpu_seconds, unit: 's', better: 'lower' });
}
fs.writeFileSync('build/bench/gap-peers.md', page);
fs.writeFileSync('build/bench/gap-peers.json', JSON.stringify(figures, null, 1) + '\n');
E2
cat build/bench/gap-peers.md
