// The drawings that modules offer: shown here, or sent to the viewer (RoboViz, the match page) that the agent was given.
import { complain, make } from './dom.js';
import { shortName } from './paths.js';

export class DrawingList {
  constructor({ place, link, field, onChange }) {
    Object.assign(this, { place, link, field, onChange });
    this.watches = new Map();
    this.waiting = new Set(); // wanted, and not known until the code that draws has run
  }

  take(entries) {
    for (const { id } of entries) if (this.waiting.delete(id)) this.show(id, true);
    const key = JSON.stringify(entries);
    if (key === this.key) return;
    this.key = key;
    const title = (textContent, why) => make('span', { className: 'title', textContent, title: why });
    this.place.replaceChildren(title('here', 'On this page'), title('viewer', 'In RoboViz or bin/webmonitor'), title('', ''),
      ...entries.flatMap(({ id, held }) => {
        const here = make('input', { type: 'checkbox', checked: this.watches.has(id), onchange: () => this.show(id, here.checked) });
        here.dataset.drawing = id;
        const viewer = make('input', { type: 'checkbox', checked: held });
        viewer.onchange = () => this.link.ask(`dr ${id}${viewer.checked ? '' : ' off'}`).catch(complain);
        return [here, viewer, make('span', { textContent: shortName(id), title: id, onclick: () => here.click() })];
      }));
  }

  show(id, on) {
    this.watches.get(id)?.end();
    this.watches.delete(id);
    this.waiting.delete(id);
    this.field.show(id, null);
    if (on) this.watches.set(id, this.link.watch(id, '0.1s', (shapes) => this.field.show(id, shapes), (error) => this.fail(id, error)));
    if (on) this.onShown?.();
    const box = this.place.querySelector(`[data-drawing="${CSS.escape(id)}"]`);
    if (box) box.checked = on;
    this.onChange();
  }

  fail(id, error) {
    this.watches.get(id)?.end();
    this.watches.delete(id);
    if (this.key?.includes(JSON.stringify(id))) complain(error);
    else this.waiting.add(id);
  }

  names() { return [...this.watches.keys(), ...this.waiting]; }
}
