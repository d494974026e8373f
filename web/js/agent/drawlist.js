// The drawings that modules offer: shown here, or sent to the viewer (RoboViz, the match page) that the agent was given.
import { complain, make } from './dom.js';
import { shortName } from './paths.js';

export class DrawingList {
  constructor({ place, link, field, onChange }) {
    Object.assign(this, { place, link, field, onChange });
    this.watches = new Map();
  }

  take(entries) {
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
    this.field.show(id, null);
    if (on) this.watches.set(id, this.link.watch(id, '0.1s', (shapes) => this.field.show(id, shapes), complain));
    const box = this.place.querySelector(`[data-drawing="${CSS.escape(id)}"]`);
    if (box) box.checked = on;
    this.onChange();
  }

  names() { return [...this.watches.keys()]; }
}
