// The moment that the page shows: of a live agent its game's clock; of an agent on a log a bar to play it, to step through
// it and to go to any time. It speaks the protocol as rdb does: replay:time, replay:cycle, replay:step, ...
import { complain, make } from './dom.js';

const speeds = [0.1, 0.2, 0.5, 1, 2, 5, 0];
const settled = 130; // between two passages of what is watched every 0.1 s [ms]
const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

export class Moment {
  constructor({ place, link }) {
    Object.assign(this, { place, link });
    link.watch('representation:FrameInfo.time', '0.2s', (time) => {
      if (!this.bar) place.textContent = `live, ${time.toFixed(1)} s`;
    });
  }

  // Whether there is a log, from the names that the agent knows.
  async take(ids) {
    if (this.asked || !ids.includes('replay:span')) return;
    this.asked = true;
    try {
      this.span = (await this.link.ask('get replay:span'))[0].value;
    } catch (error) {
      this.asked = false;
      return;
    }
    this.build();
  }

  build() {
    const { first, last } = this.span;
    const button = (id, textContent, title, run) => make('button', { id, textContent, title, onclick: () => run().catch(complain) });
    this.play = button('momentPlay', '▶', 'Play and stop (space)', () => this.toggle());
    this.back = button('momentBack', '◀|', 'A cycle back (comma)', () => this.step(-1));
    this.on = button('momentStep', '|▶', 'A cycle on (full stop)', () => this.step(1));
    this.slider = make('input', { type: 'range', id: 'momentSlider', min: first, max: last, step: 0.02, set: { 'aria-label': 'Time of the log' } });
    this.slider.oninput = () => this.drag(Number(this.slider.value));
    this.slider.onchange = () => this.jump(Number(this.slider.value)).catch(complain);
    this.time = make('input', { type: 'number', id: 'momentTime', min: first, max: last, step: 0.02, title: 'Go to this time [s]' });
    this.time.onchange = () => this.jump(Number(this.time.value)).catch(complain);
    this.count = make('span', { id: 'momentCycle' });
    this.speed = make('select', { id: 'momentSpeed', title: 'How fast it plays' }, ...speeds.map((value) => make('option', { value, textContent: value ? `${value} ×` : 'as it goes' })));
    this.speed.value = 1;
    this.speed.onchange = () => this.link.ask(`set replay:speed ${this.speed.value}`).catch(complain);
    this.bar = make('div', { id: 'momentBar' }, make('b', { textContent: 'log' }), this.back, this.play, this.on, this.slider, this.time, ' s', this.count, this.speed);
    this.place.replaceChildren(this.bar);
    this.link.ask(`set replay:speed ${this.speed.value}`).catch(complain);
    this.link.watch('replay:paused', '0.1s', (paused) => { this.paused = paused; this.play.textContent = paused ? '▶' : '❚❚'; });
    this.link.watch('replay:cycle', '0.1s', (cycle) => { this.cycle = cycle; this.count.textContent = `cycle ${cycle} of ${this.span.cycles}`; });
    this.link.watch('replay:time', '0.1s', (time) => this.show(time));
    // Plots have the log's time; this value comes before those of the modules in the same cycle.
    this.link.watch('representation:FrameInfo.time', '', (time) => { this.link.moment = time; });
    document.addEventListener('keydown', (event) => this.key(event));
  }

  show(time) {
    this.at = time;
    if (!this.dragging) this.slider.value = time;
    if (document.activeElement !== this.time) this.time.value = time.toFixed(2);
  }

  key(event) {
    if (document.body.classList.contains('editing') || event.target.matches?.('input:not([type="range"]), select, button')) return;
    const button = { ' ': this.play, ',': this.back, '.': this.on }[event.key];
    if (!button) return;
    event.preventDefault();
    button.click();
  }

  toggle() { return this.link.ask(`set replay:paused ${!this.paused}`); }

  // While the slider moves, at most one order is under way.
  async drag(time) {
    this.wanted = time;
    this.time.value = time.toFixed(2);
    if (this.dragging) return;
    this.dragging = true;
    try {
      while (this.wanted !== null) {
        const next = this.wanted;
        this.wanted = null;
        await this.link.ask('set replay:paused true');
        await this.link.ask(`set replay:time ${next}`);
      }
    } catch (error) { complain(error); }
    this.dragging = false;
  }

  // One after the other, however fast one clicks.
  inTurn(run) {
    this.turn = (this.turn ?? Promise.resolve()).catch(() => {}).then(run);
    return this.turn;
  }

  async where(name) {
    for (let i = 0; ; ++i) {
      try {
        return (await this.link.ask(`get replay:${name}`))[0].value;
      } catch (error) {
        if (i === 30) throw error; // a long log takes its time on the way back
      }
    }
  }

  // What is drawn is drawn in a cycle that is played, so the last one is a step of its own, when each watch is due again.
  async arrive() {
    await pause(settled);
    await this.link.ask('dr replay:step');
    await this.where('cycle');
  }

  step(by) {
    return this.inTurn(async () => {
      const to = Math.max(1, Math.min(this.span.cycles, (await this.where('cycle')) + by));
      await this.link.ask('set replay:paused true');
      if (by <= 0) await this.link.ask(`set replay:cycle ${to - 1}`);
      await this.where('cycle');
      await this.arrive();
    });
  }

  // The same cycle once more, for what has begun to look while the log rests.
  again() {
    clearTimeout(this.soon);
    this.soon = setTimeout(() => { if (this.bar && this.paused && this.cycle > 0) this.step(0).catch(complain); }, 200);
  }

  jump(time) {
    return this.inTurn(async () => {
      while (this.dragging) await pause(20);
      const to = Math.max(this.span.first, Math.min(this.span.last, time || 0));
      await this.link.ask('set replay:paused true');
      await this.link.ask(`set replay:time ${Math.max(0, to - 0.03)}`);
      let now = await this.where('time');
      // The last cycles may have one time: of a log whose game ended, the end is its last cycle.
      const there = async () => now > to - 0.009 && (to < this.span.last || (await this.where('cycle')) >= this.span.cycles);
      for (let i = 0; i < 6 && !(await there()); ++i) {
        await this.arrive();
        now = await this.where('time');
      }
      this.show(now);
    });
  }
}
