// The module graph as it runs: a frame for each thread, a column for each area in the order of execution, a box for each
// module with its time and what it provides. A chosen module shows what it reads (blue) and who reads it (orange).
import { make } from './dom.js';

const svg = 'http://www.w3.org/2000/svg';

// Columns of a thread: neighbours in the order of execution that are of one area; areas that come back go to their column
// unless much has come in between.
export function columnsOf(modules) {
  const columns = [];
  for (const module of modules) {
    const recent = columns.slice(-3).find((column) => column.area === module.area);
    if (recent) recent.modules.push(module);
    else columns.push({ area: module.area, modules: [module] });
  }
  return columns;
}

function timeText(us) { return us >= 1000 ? `${(us / 1000).toFixed(1)} ms` : `${us < 10 ? us.toFixed(1) : Math.round(us)} µs`; }

export class Graph {
  constructor({ place, columns, edges, threads, onRepresentation, onModule }) {
    Object.assign(this, { place, columns, edges, threads, onRepresentation, onModule });
    this.boxes = new Map(); // by thread and module
    this.chosen = null;
  }

  // Lines of the command `graph`.
  take(lines) {
    const threads = lines.filter((line) => 'thread' in line).map((thread) => ({ ...thread, modules: lines.filter((line) => line.of === thread.thread) }));
    this.headline(threads);
    const shape = JSON.stringify(threads.map((t) => [t.thread, t.copies, t.modules.map(({ us, waits, ...rest }) => rest)]));
    if (shape !== this.shape) this.build(threads);
    this.shape = shape;
    for (const thread of threads) {
      const longest = Math.max(1, ...thread.modules.map(({ us }) => us));
      for (const module of thread.modules) {
        const { time, bar } = this.boxes.get(`${thread.thread}/${module.module}`);
        time.textContent = timeText(module.us);
        time.parentElement.title = `a cycle${module.waits > 1 ? `, without ${timeText(module.waits)} of waiting` : ''}`;
        bar.style.width = `${Math.max(1, (100 * module.us) / longest)}%`;
        bar.style.background = module.us > 0.4 * longest && module.us > 20 ? '#ffb05a' : '#8fe0a8';
      }
    }
  }

  headline(threads) {
    this.threads.replaceChildren(...threads.map(({ thread, load, us, rate, overruns, cycles }) => {
      const late = rate > 0 ? `, ${overruns} of ${cycles} over` : '';
      return make('span', { className: overruns ? 'over' : '', textContent: `${thread}: ${timeText(us)} a cycle, ${(100 * load).toFixed(1)} %${late}` });
    }));
  }

  build(threads) {
    this.boxes.clear();
    this.providers = new Map();
    this.columns.replaceChildren(...threads.map((thread) => make('div', { className: 'thread' },
      make('h2', { textContent: thread.thread }),
      make('div', { className: 'areas' }, ...columnsOf(thread.modules).map(({ area, modules }) => make('div', { className: 'area' },
        make('h3', { textContent: area || 'others' }), ...modules.map((module) => this.box(thread, module))))))));
    for (const thread of threads) // what is copied is provided by the other thread's module
      for (const { thread: from, representation } of thread.copies)
        this.providers.set(`${thread.thread}/${representation}`, this.providers.get(`${from}/${representation}`));
    requestAnimationFrame(() => this.connect());
  }

  box(thread, module) {
    const time = make('span'), bar = make('i');
    const provides = module.provides.map((name) => {
      const link = make('a', { textContent: name, title: `look at ${name}` });
      link.onclick = () => this.onRepresentation(name);
      return link;
    });
    const title = make('div', { className: 'title', textContent: module.module, title: `${module.module}: reads ${module.reads.join(', ') || 'nothing'}` });
    const element = make('div', { className: 'module' }, title, make('div', { className: 'time' }, make('div', {}, bar), time), ...provides);
    element.dataset.module = module.module;
    const box = { element, time, bar, module, thread: thread.thread };
    title.onclick = () => {
      this.choose(this.chosen === box ? null : box);
      if (this.chosen) this.onModule(module.module);
    };
    element.onmouseenter = () => this.highlight(box);
    element.onmouseleave = () => this.highlight(this.chosen);
    this.boxes.set(`${thread.thread}/${module.module}`, box);
    for (const name of module.provides) this.providers.set(`${thread.thread}/${name}`, box);
    return element;
  }

  choose(box) {
    this.chosen?.element.classList.remove('chosen');
    this.chosen = box;
    box?.element.classList.add('chosen');
    this.highlight(box);
  }

  // Curves from who provides to who reads, once for each pair.
  connect() {
    const size = [this.columns.offsetWidth, this.columns.offsetHeight];
    this.edges.setAttribute('width', size[0]);
    this.edges.setAttribute('height', size[1]);
    const origin = this.edges.getBoundingClientRect();
    const paths = new Map();
    for (const to of this.boxes.values())
      for (const name of [...to.module.reads, ...to.module.uses]) {
        const from = this.providers.get(`${to.thread}/${name}`);
        if (!from || from === to || paths.has(`${from.module.module}>${to.module.module}`)) continue;
        const path = document.createElementNS(svg, 'path');
        path.setAttribute('d', this.curve(from.element.getBoundingClientRect(), to.element.getBoundingClientRect(), origin));
        paths.set(`${from.module.module}>${to.module.module}`, { path, from, to });
      }
    this.paths = [...paths.values()];
    this.edges.replaceChildren(...this.paths.map(({ path }) => path));
    this.highlight(this.chosen);
  }

  curve(a, b, origin) {
    const sameColumn = Math.abs(a.left - b.left) < 2, back = b.left < a.left;
    const x1 = (sameColumn || !back ? a.right : a.left) - origin.left, y1 = a.top + a.height / 2 - origin.top;
    const x2 = (sameColumn || back ? b.right : b.left) - origin.left, y2 = b.top + b.height / 2 - origin.top;
    const reach = sameColumn ? 18 : Math.max(20, Math.abs(x2 - x1) / 2);
    return `M${x1} ${y1} C${x1 + (back ? -reach : reach)} ${y1} ${x2 + (sameColumn || back ? reach : -reach)} ${y2} ${x2} ${y2}`;
  }

  highlight(box) {
    for (const { path, from, to } of this.paths ?? []) {
      const kind = box && to === box ? 'in' : box && from === box ? 'out' : '';
      path.setAttribute('class', kind);
      if (kind) this.edges.append(path);
    }
  }
}
