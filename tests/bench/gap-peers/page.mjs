// The page of `make bench-gap-peers` from its pieces: node page.mjs FOLDER PIECE...
import fs from 'node:fs';
import path from 'node:path';

const [kept, ...pieces] = process.argv.slice(2);
const read = (file) => JSON.parse(fs.readFileSync(file)), percent = (x) => `${Math.round(100 * x)} %`;
const figures = [], splits = new Map();
const rowsOf = (split) => splits.get(split) ?? splits.set(split, []).get(split);
const labels = { 'mujoco-gauss-newton': 'what MuJoCo\u2019s sysid fits, Gauss-Newton', 'pace-cma-es': 'what PACE fits, CMA-ES', 'everything-gauss-newton': 'everything per joint, Gauss-Newton', 'everything-cma-es': 'everything per joint, CMA-ES', single: 'best single effect' };
const runsOf = (runs) => runs.map((r) => `${path.basename(r.folder)} ${percent(r.closed)}`).join(', ');

let claims = '';
for (const piece of pieces) {
  const name = path.basename(piece), method = name.slice(name.lastIndexOf('.') + 1), split = name.slice(0, -method.length - 1);
  const answer = read(`${piece}.json`), check = read(`${piece}.check.json`), timing = read(`${piece}.timing.json`);
  const range = check.claimed_interval ? `${percent(check.claimed_interval[0])} to ${percent(check.claimed_interval[1])}` : '';
  const causes = answer.effects.map((e) => `${e.effect} at ${e.at} ${e.value.toPrecision(3)} (${e.probability.toFixed(2)})`).join(', ');
  const further = fs.existsSync(`${piece}.further.json`) ? { ...answer.gap.further, check: read(`${piece}.further.json`) } : null;
  claims += `| ${split} | ${method} | ${causes || 'none'} | ${percent(check.claimed)} | ${range} | ${percent(check.closed)} | ` +
    `${further ? `${further.parameters} | ${percent(further.check.claimed)} | ${percent(further.check.closed)}` : '| |'} |\n`;
  const { model } = answer.gap, kinds = model ? `: ${new Set(model.map((c) => c.effect)).size} kinds of causes, each in every joint` : '';
  rowsOf(split).push({ ours: true, method: `**bin/gap, ${method}${kinds}**`, parameters: (model ?? answer.effects).length, closed: check.closed, runs: runsOf(check.runs), cpu: timing.cpu_seconds, attributable: 'yes' });
  if (further) {
    rowsOf(split).push({ ours: false, further: true, method: `**bin/gap, ${method}, all values of all joints beside the kinds (\`--further\`)**`, parameters: further.parameters, closed: further.check.closed, runs: runsOf(further.check.runs), cpu: NaN, attributable: 'no' });
    figures.push({ name: `gap-peers.closed.${split}.${method}-further`, value: further.check.closed, unit: '1', better: 'higher' },
      { name: `gap-peers.claim-off.${split}.${method}-further`, value: Math.abs(further.check.claimed - further.check.closed), unit: '1', better: 'lower', target: 0.1 });
  }
  figures.push({ name: `gap-peers.closed.${split}.${method}`, value: check.closed, unit: '1', better: 'higher' },
    { name: `gap-peers.claim-off.${split}.${method}`, value: Math.abs(check.claimed - check.closed), unit: '1', better: 'lower', target: 0.1 },
    { name: `gap-peers.cpu.${split}.${method}`, value: timing.cpu_seconds, unit: 's', better: 'lower' });
}
for (const file of fs.readdirSync(kept).filter((f) => /\.peer-.*\.json$/.test(f)).sort()) {
  const piece = read(path.join(kept, file));
  if (!splits.has(piece.split)) continue;
  const label = labels[piece.peer] ?? `BAM's ${piece.peer.slice(4).toUpperCase()} per joint`;
  rowsOf(piece.split).push({ peer: piece.peer, method: `${label} (${piece.what})`, parameters: piece.parameters, closed: piece.closed, fitted: piece.fitted_closed, runs: runsOf(piece.runs), cpu: piece.cpu_seconds, attributable: piece.peer === 'single' ? 'one' : 'no' });
  figures.push({ name: `gap-peers.closed.${piece.split}.${piece.peer}`, value: piece.closed, unit: '1', better: 'higher' });
}
let page = `Every way saw the recordings for fitting alone (segments of 20 s of long ones), then recordings of other motions were
replayed free from their first sample. Closed: 1 - after/before, root mean squares of the positions, the mean over the recordings.
Nothing that was left is taken as a floor: there is no repeat. Everything per joint: rotor inertia, five frictions and damping,
gain, torque limit, zero, bias and delay. MuJoCo's system identification fits rotor inertia, damping, dry friction and gain of a
position actuator; PACE fits rotor inertia, damping, dry friction, zero and delay. BAM's models are those of Duclusaud et al.
2024, with the rotor's inertia. Gauss-Newton begins at the nominal model and at values drawn at random, with each form of load
friction, and the best on the recordings fitted is taken. CMA-ES has seed 7. Of a robot with several motors bin/gap finds kinds
of causes and gives each a value in every joint; its values are counted without those that do nothing.
`;
for (const [split, rows] of splits) {
  const peers = rows.filter((r) => r.peer), best = peers.reduce((a, b) => (b.closed > (a?.closed ?? -Infinity) ? b : a), null);
  page += `\n## ${split}\n\n| way | values | closed on recordings fitted | closed on others | per recording | CPU s |\n|---|---|---|---|---|---|\n`;
  for (const r of [...rows].sort((a, b) => b.closed - a.closed))
    page += `| ${r.method} | ${r.parameters} | ${r.fitted === undefined ? '' : percent(r.fitted)} | ${percent(r.closed)} | ${r.runs} | ${Number.isNaN(r.cpu) ? 'with the causes' : r.cpu < 10 ? r.cpu.toFixed(1) : Math.round(r.cpu)} |\n`;
  const ours = rows.find((r) => r.ours);
  if (!best || !ours) continue;
  const behind = best.closed - ours.closed;
  page += `\nOurs closes ${percent(ours.closed)} with ${ours.parameters === 1 ? '1 value' : `${ours.parameters} values`}, the best of the others ${percent(best.closed)} with ${best.parameters}: ${best.method}.` +
    rows.filter((r) => r.further).map((r) => ` All values of all joints that it fits beside close ${percent(r.closed)} with ${r.parameters}.`).join('') + '\n';
  figures.push({ name: `gap-peers.behind-best.${split}`, value: behind, unit: '1', better: 'lower', target: 0.02 },
    { name: `gap-peers.values-over-best.${split}`, value: ours.parameters / best.parameters, unit: '1', better: 'lower', target: 0.334 });
}
const absent = fs.readFileSync('tests/bench/gap-peers/splits.txt', 'utf8').split('\n').filter((l) => l && l[0] !== '#').map((l) => l.split('|')[0]).filter((n) => !splits.has(n));
if (absent.length) page += `\nNot measured this time: ${absent.join(', ')}.\n`;
page += `\n## What the answers claim\n\nClaimed: what the answer says of a recording that it did not see (by \`blocks\`: of half-seconds of the same
recordings). Further: values of all joints that are fitted at once beside the kinds named (\`gap.further\`), what is claimed of them and what they
close; they do not say what is missing.\n
| split | method | causes | claimed | 90 % of it | measured | further: values | claimed | measured |\n|---|---|---|---|---|---|---|---|---|\n${claims}`;
fs.writeFileSync('build/bench/gap-peers.md', page);
fs.writeFileSync('build/bench/gap-peers.json', JSON.stringify(figures, null, 1) + '\n');
