// A value as a tree of its parts. A number can be plotted, a place shown on the field, a part set by a double click.
import { complain, make } from './dom.js';
import { partName, placeOf, shown, valueText } from './paths.js';

const most = 60; // elements of a list

export class TextPanel {
  constructor({ body, name, link, panels }) {
    Object.assign(this, { body, name, link, panels });
    this.leaves = new Map(); // by name of the part
    this.set = make('button', { textContent: 'set', title: 'Overwrite the whole value in every cycle' });
    this.unset = make('button', { textContent: 'unset', title: 'Let the agent have its own value again', hidden: true });
    this.set.onclick = () => this.edit(this.name, this.set);
    this.unset.onclick = () => this.release();
    this.buttons = [this.set, this.unset];
    this.held = new Set();
    this.watch = link.watch(name, '0.1s', (value) => this.take(value), (error) => this.fail(error));
  }

  end() { this.watch.end(); }

  fail(error) { this.body.replaceChildren(make('div', { className: 'error', textContent: error })); }

  take(value) {
    const shape = this.shapeOf(value);
    if (shape !== this.shape) {
      this.shape = shape;
      this.leaves.clear();
      this.body.replaceChildren(this.tree(this.name, '', value));
    }
    this.fill(this.name, value);
  }

  // What decides which rows there are.
  shapeOf(value) {
    if (value === null || typeof value !== 'object') return '.';
    return Array.isArray(value) ? `[${value.slice(0, most).map((v) => this.shapeOf(v))}${value.length > most ? value.length : ''}]`
      : `{${Object.entries(value).map(([key, v]) => key + this.shapeOf(v))}}`;
  }

  tree(name, key, value) {
    const group = value !== null && typeof value === 'object';
    const row = make('div', { className: 'row' }, key === '' ? null : make('span', { className: 'key', textContent: key }));
    if (placeOf(value)) row.append(this.act('on the field', 'Show this place on the field', () => this.panels.field.follow(name)));
    if (!group) {
      const leaf = make('span', { className: 'leaf', title: 'double click: set' });
      leaf.ondblclick = () => this.edit(name, leaf);
      this.leaves.set(name, leaf);
      row.append(leaf);
      if (typeof value !== 'string') {
        const plot = this.act('plot', 'Plot it; with shift: in the last plot', (event) => this.panels.plotValue(name, event.shiftKey));
        row.append(plot);
      }
      return make('div', { className: 'tree' }, row);
    }
    const entries = Object.entries(value);
    const rows = entries.slice(0, most).map(([k, v]) => this.tree(partName(name, value, k), k, v));
    if (entries.length > most) rows.push(make('div', { className: 'key', textContent: `and ${entries.length - most} more` }));
    if (!entries.length) row.append(make('span', { className: 'key', textContent: 'empty' }));
    return make('div', { className: 'tree' }, row, ...rows);
  }

  act(text, title, run) { return make('span', { className: 'act', textContent: text, title, onclick: run }); }

  fill(name, value) {
    if (value !== null && typeof value === 'object') {
      Object.entries(value).slice(0, most).forEach(([key, v]) => this.fill(partName(name, value, key), v));
      return;
    }
    const leaf = this.leaves.get(name);
    const text = shown(value);
    if (leaf && leaf.textContent !== text) leaf.textContent = text;
  }

  edit(name, beside) {
    const input = make('input', { type: 'text', value: beside.className === 'leaf' ? beside.textContent : '', title: 'Enter: set; Escape: leave it' });
    input.placeholder = beside.className === 'leaf' ? '' : '{1 2 3}';
    const leave = () => input.remove();
    input.onblur = leave;
    input.onkeydown = (event) => {
      if (event.key === 'Escape') leave();
      if (event.key !== 'Enter') return;
      const value = valueText(input.value);
      leave();
      this.assign(name, value);
    };
    beside.after(input);
    input.select();
    input.focus();
  }

  async assign(name, value) {
    try {
      await this.link.ask(`set ${name} ${value}`);
      this.held.add(name);
      this.unset.hidden = false;
    } catch (error) { complain(error); }
  }

  async release() {
    this.unset.hidden = true;
    this.held.clear();
    await this.link.ask(`unset ${this.name}`).catch(complain);
  }
}
