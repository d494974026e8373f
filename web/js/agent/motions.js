// Motions on request: the page overwrites what the behaviour wants, until it is handed back.
import { complain, make } from './dom.js';

const request = 'representation:MotionRequest';
const axes = [['forward', 'walkVelocity.x', 0.5, 'm/s'], ['left', 'walkVelocity.y', 0.3, 'm/s'], ['turn', 'walkTurn', 1.2, 'rad/s']];

export class Motions {
  constructor({ place, link }) {
    Object.assign(this, { place, link, orders: 0 });
    this.state = make('span', { className: 'key', textContent: 'the behaviour decides' });
  }

  take(names) {
    const key = JSON.stringify(names);
    if (key === this.key) return;
    this.key = key;
    const button = (text, title, run) => make('button', { textContent: text, title, onclick: run, set: { 'data-motion': text } });
    this.place.replaceChildren(
      button('stand', 'Stand', () => this.ask([['motion', 'stand']], 'stand')),
      ...names.map((name) => make('span', { className: 'motion' },
        button(name, 'A motion of config/motions', () => this.ask([['specialAction', `"${name}"`], ['motion', 'specialAction']], name)),
        make('button', { textContent: '✎', title: `Edit ${name}`, onclick: () => this.onEdit?.(name), set: { 'data-edit': name } }))),
      button('hand back', 'The behaviour decides again', () => this.handBack()), this.state, this.walk());
  }

  walk() {
    const rows = axes.map(([name, part, reach, unit]) => {
      const value = make('span', { textContent: `0 ${unit}` });
      const slider = make('input', { type: 'range', min: -reach, max: reach, step: reach / 50, value: 0 });
      slider.oninput = () => {
        value.textContent = `${Number(slider.value).toFixed(2)} ${unit}`;
        this.wanted = [...(this.wanted ?? []).filter(([p]) => p !== part), [part, slider.value]];
        if (!this.busy) this.follow();
      };
      return [name, slider, value];
    });
    return make('div', { className: 'walk' }, ...rows.flat().map((child) => (typeof child === 'string' ? make('span', { textContent: child }) : child)));
  }

  async follow() {
    this.busy = true;
    while (this.wanted) {
      const parts = this.wanted;
      this.wanted = null;
      await this.ask([...parts, ['motion', 'walk']], 'walk');
    }
    this.busy = false;
  }

  // What is asked last counts: of what is under way, no further part is sent.
  async ask(parts, name) {
    const order = ++this.orders;
    try {
      for (const [part, value] of parts) {
        if (order !== this.orders) return;
        await this.link.ask(`set ${request}.${part} ${value}`);
      }
      if (order === this.orders) this.state.textContent = `requested: ${name}`;
    } catch (error) { complain(error); }
  }

  async handBack() {
    ++this.orders;
    await this.link.ask(`unset ${request}`).catch(complain);
    this.state.textContent = 'the behaviour decides';
  }
}
