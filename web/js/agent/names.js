// The list of all that can be looked at, by kind, with a field to find a name in it.
import { make } from './dom.js';
import { shortName } from './paths.js';

const kinds = [
  ['Representations', 'representation:'], ['Values in modules', 'module:'], ['Parameters', 'config:'], ['Stopwatches', 'timing:'],
];
const most = 400; // links of a kind at once

export class Names {
  constructor({ list, filter, onChoose }) {
    Object.assign(this, { list, filter, onChoose });
    this.all = [];
    this.shown = new Set();
    this.closed = new Set(['config:', 'timing:']);
    filter.oninput = () => this.draw();
    filter.onkeydown = (event) => {
      if (event.key === 'Enter') list.querySelector('a')?.click();
      if (event.key === 'Escape') { filter.value = ''; this.draw(); }
    };
    document.addEventListener('keydown', (event) => {
      if (event.key !== '/' || event.target.matches?.('input')) return;
      event.preventDefault();
      filter.focus();
    });
  }

  take(entries) {
    const key = JSON.stringify(entries);
    if (key === this.key) return;
    this.key = key;
    this.all = entries;
    this.draw();
  }

  mark(names) {
    this.shown = new Set(names);
    for (const link of this.list.querySelectorAll('a')) link.classList.toggle('shown', this.shown.has(link.dataset.name));
  }

  draw() {
    const wanted = this.filter.value.toLowerCase().split(/\s+/).filter(Boolean);
    const fits = ({ id }) => wanted.every((word) => id.toLowerCase().includes(word));
    this.list.replaceChildren(...kinds.map(([title, prefix]) => {
      const entries = this.all.filter((entry) => entry.id.startsWith(prefix) && fits(entry));
      const group = make('details', { open: wanted.length > 0 || !this.closed.has(prefix) },
        make('summary', { textContent: `${title} (${entries.length})` }),
        ...entries.slice(0, most).map((entry) => this.link(entry)));
      group.ontoggle = () => (group.open ? this.closed.delete(prefix) : this.closed.add(prefix));
      return group;
    }));
  }

  link({ id, kind, held }) {
    const link = make('a', { textContent: shortName(id), title: `${id} (${kind})`, tabIndex: 0 });
    link.dataset.name = id;
    link.classList.toggle('shown', this.shown.has(id));
    link.classList.toggle('held', held);
    link.onclick = () => this.onChoose(id, kind);
    link.onkeydown = (event) => { if (event.key === 'Enter') link.click(); };
    return link;
  }
}
