// Puts the parts of the agent's page together.
import { Coach } from './coach.js';
import { DrawingList } from './drawlist.js';
import { Editor } from './editor.js';
import { Field } from './field.js';
import { Graph } from './graph.js';
import { DebugLink } from './link.js';
import { Moment } from './moment.js';
import { Motions } from './motions.js';
import { Names } from './names.js';
import { Panels } from './panels.js';
import { complain } from './dom.js';

const $ = (id) => document.getElementById(id);
let abouts = new Map(), known = [];

const link = new DebugLink({
  onState(open) {
    $('online').textContent = open ? 'connected' : 'connection lost; trying again';
    $('online').classList.toggle('lost', !open);
    if (open) begin().catch(complain);
  },
  onLost: complain,
});
const field = new Field({ canvas: $('view'), legend: $('legend'), link, onChange: keep });
const panels = new Panels({ place: $('panels'), link, field, about: (name) => abouts.get(name), onChange: keep });
const drawings = new DrawingList({ place: $('drawingList'), link, field, onChange: keep });
const motions = new Motions({ place: $('motionList'), link });
const editor = new Editor({ link, motions, onOpen: keep });
const coach = new Coach({ link, onOpen: keep });
motions.onEdit = (name) => editor.open(name);
const names = new Names({ list: $('list'), filter: $('filter'), onChoose: (name, kind) => panels.choose(name, kind) });
const graph = new Graph({
  place: $('graph'), columns: $('columns'), edges: $('edges'), threads: $('threads'),
  onRepresentation: (name) => panels.text(`representation:${name}`),
  onModule: (name) => { $('filter').value = name; names.draw(); },
});
drawings.onShown = () => moment.again();
// One view at a time.
$('toModules').onclick = () => { coach.close(); editor.close(); };
$('toMotion').onclick = () => { coach.close(); editor.open(); };
$('toFormation').onclick = () => { editor.close(); coach.open(); };
const moment = new Moment({ place: $('moment'), link });
for (const button of document.querySelectorAll('#cameras button')) button.onclick = () => field.choose(button.dataset.look);

// The address keeps what is shown.
let restored = false;
function keep() {
  if (!restored) return;
  const state = [...panels.state(), ...drawings.names().map((name) => ['draw', name]), ...[...field.places].map(([name, { frame }]) => ['place', `${name},${frame}`]),
    ...(editor.isOpen && editor.motion ? [['edit', editor.motion.name]] : []), ...(coach.isOpen ? [['formation', 'open']] : [])];
  history.replaceState(null, '', `${location.pathname}${location.search}#${state.map(([kind, value]) => `${kind}=${value}`).join('&')}`);
  names.mark(panels.names());
}

function restore() {
  for (const part of decodeURI(location.hash.slice(1)).split('&')) {
    const [kind, value] = part.split(/=(.*)/s);
    if (!value) continue;
    if (kind === 'draw') drawings.show(value, true);
    else if (kind === 'edit') editor.open(value);
    else if (kind === 'formation') coach.open();
    else if (kind === 'place') field.follow(...value.split(','));
    else panels.restore(kind, value.split(','));
  }
  restored = true;
  keep();
}

async function begin() {
  abouts = new Map((await link.ask('about')).map((line) => [line.id, line]));
  await refresh();
  const player = await link.ask('get representation:PlayerInfo').catch(() => []);
  if (player[0]) $('who').textContent = `${player[0].value.team || 'agent'} ${player[0].value.number || ''}`;
  const dimensions = await link.ask('get representation:FieldDimensions').catch(() => []);
  if (dimensions[0]) field.setDimensions(dimensions[0].value);
  if (restored) return;
  const asked = location.hash.length > 1;
  restore();
  // An agent that was started with a motion is looked at for its sake.
  if (asked || !editor.names.length) return;
  const opened = await link.ask('get module:MotionEditor:opened').catch(() => []);
  if (opened[0]?.value) editor.open(opened[0].value);
}

// Code makes its values known when execution passes them first, so the list grows.
async function refresh() {
  known = (await link.ask('list')).filter(({ id }) => id);
  moment.take(known.map(({ id }) => id));
  names.take(known.filter(({ kind }) => kind !== 'drawing'));
  drawings.take(known.filter(({ kind }) => kind === 'drawing'));
  editor.offer(known.filter(({ id }) => id.startsWith('motion:')).map(({ id }) => id.slice(7)));
  coach.offer(known.some(({ id }) => id === 'formation'));
  graph.take(await link.ask('graph'));
  if (!motions.key && known.some(({ id }) => id === 'module:SpecialActions:motions'))
    motions.take((await link.ask('get module:SpecialActions:motions'))[0].value);
}
setInterval(() => { if (link.online && !document.hidden) link.ask('graph').then((lines) => graph.take(lines)).catch(() => {}); }, 1000);
setInterval(() => { if (link.online && !document.hidden) refresh().catch(() => {}); }, 3000);

// For tests and the console.
window.plumbline = {
  link, field, panels, drawings, editor, coach, moment,
  state: () => ({
    online: link.online, names: known.length, modules: graph.boxes.size, edges: graph.paths?.length ?? 0,
    panels: panels.state(), drawings: drawings.names(), shapes: field.drawings.count, ground: Boolean(field.ground),
    robot: field.robot, robots: [], motions: editor.names,
  }),
};
