// A parameter: its value, what it does, and a slider over its range. What is refused is said and changes nothing.
import { complain, make } from './dom.js';
import { reachOf, shown, valueText } from './paths.js';

export class ParameterPanel {
  constructor({ body, name, about, link }) {
    Object.assign(this, { body, name, link });
    this.back = make('button', { textContent: 'undo', title: 'The value it had before' });
    this.back.onclick = () => link.ask(`unset ${name}`).catch(complain);
    this.buttons = [this.back];
    this.body.append(make('div', { className: 'comment', textContent: this.comment(about) }), this.control(about ?? { type: 'text' }));
    this.watch = link.watch(name, '0.2s', (value) => this.show(value), complain);
  }

  end() { this.watch.end(); }

  comment(about) {
    if (!about) return '';
    const range = about.min === null && about.max === null ? '' : ` [${about.min ?? '-∞'} .. ${about.max ?? '∞'}]`;
    return `${about.comment}${about.unit ? `, ${about.unit}` : ''}${range}; default ${about.default}`;
  }

  control(about) {
    const row = make('div', { className: 'slide' });
    if (about.type === 'bool') {
      this.input = make('input', { type: 'checkbox', onchange: () => this.set(String(this.input.checked)) });
      this.show = (value) => { this.input.checked = value; };
    } else if (about.words?.length) {
      this.input = make('select', { onchange: () => this.set(`"${this.input.value}"`) }, ...about.words.map((word) => make('option', { textContent: word })));
      this.show = (value) => { this.input.value = value; };
    } else if (['int', 'unsigned', 'double', 'float'].includes(about.type) || /int|number/.test(about.type)) {
      return this.number(about, row);
    } else {
      this.input = make('input', { type: 'text', onchange: () => this.set(valueText(this.input.value)) });
      this.show = (value) => {
        if (document.activeElement !== this.input) this.input.value = Array.isArray(value) ? `{${value.join(' ')}}` : value;
      };
    }
    row.append(this.input);
    return row;
  }

  number(about, row) {
    const [min, max] = reachOf(about), whole = !/double|float/.test(about.type);
    this.slider = make('input', { type: 'range', min, max, step: whole ? 1 : (max - min) / 200 });
    this.input = make('input', { type: 'number', step: 'any' });
    // While it moves, at most one order is under way.
    this.slider.oninput = () => {
      this.input.value = this.slider.value;
      this.wanted = this.slider.value;
      if (!this.busy) this.follow();
    };
    this.input.onchange = () => this.set(this.input.value);
    this.show = (value) => {
      if (this.busy || document.activeElement === this.input) return;
      this.slider.value = value;
      this.input.value = shown(value);
    };
    row.append(this.slider, this.input);
    return row;
  }

  async follow() {
    this.busy = true;
    while (this.wanted !== undefined) {
      const value = this.wanted;
      this.wanted = undefined;
      await this.set(value);
    }
    this.busy = false;
  }

  set(value) { return this.link.ask(`set ${this.name} ${value}`).catch(complain); }
}
