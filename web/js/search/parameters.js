// What was found, parameter by parameter, between its bounds and beside where it began.
import { make } from '../agent/dom.js';

const text = (x) => (x === null || x === undefined ? '-' : String(Number(x.toPrecision(5))));
const atBound = 0.005; // of the width

// Where a value is between bounds, 0 to 1; where there are none, around the start.
export function place({ start, lower, upper }, value) {
  const low = lower ?? start - 5 * (Math.abs(start) || 1), high = upper ?? start + 5 * (Math.abs(start) || 1);
  return Math.max(0, Math.min(1, (value - low) / (high - low)));
}

export class Parameters {
  constructor({ place: element, filter, moved }) {
    Object.assign(this, { element, filter, moved });
    this.rows = new Map();
    this.list = [];
    filter.oninput = () => this.order();
    moved.onchange = () => this.order();
  }

  study(list) {
    this.list = list;
    this.rows = new Map(list.map((one) => {
      const way = make('i'), begin = make('u', { title: `start ${text(one.start)}` }), now = make('s');
      const value = make('b'), change = make('em');
      const row = make('div', { className: 'parameter' }, make('span', { textContent: one.name, title: one.name }), make('div', { className: 'reach', title: `${text(one.lower)} to ${text(one.upper)}` }, way, begin, now), value, change);
      begin.style.left = `${100 * place(one, one.start)}%`;
      row.dataset.parameter = one.name;
      return [one.name, { row, way, now, value, change, moved: 0 }];
    }));
    this.order();
  }

  // The middle of the last generation is what is written; the best single one may have been lucky.
  take(best, favourite) {
    this.list.forEach((one, i) => {
      const row = this.rows.get(one.name), value = favourite[i];
      if (value === null) return;
      const from = place(one, one.start), to = place(one, value);
      row.moved = Math.abs(to - from);
      Object.assign(row.way.style, { left: `${100 * Math.min(from, to)}%`, width: `${100 * row.moved}%` });
      row.now.style.left = `${100 * to}%`;
      row.now.classList.toggle('bound', to < atBound || to > 1 - atBound);
      row.value.textContent = text(value);
      row.value.title = `best single candidate: ${text(best[i])}`;
      row.change.textContent = `${value >= one.start ? '+' : '−'}${text(Math.abs(value - one.start))}`;
    });
    if (this.moved.checked) this.order();
  }

  order() {
    const words = this.filter.value.toLowerCase().split(/\s+/).filter(Boolean);
    const rows = [...this.rows].filter(([name]) => words.every((word) => name.toLowerCase().includes(word)));
    if (this.moved.checked) rows.sort((a, b) => b[1].moved - a[1].moved);
    const head = make('div', { className: 'parameter head' }, make('span', { textContent: 'name' }), make('span', { textContent: 'between its bounds: start | found' }), make('em', { textContent: 'found' }), make('em', { textContent: 'change' }));
    this.element.replaceChildren(head, ...rows.map(([, { row }]) => row));
  }
}
