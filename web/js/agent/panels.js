// Values side by side. A panel is a value as text, a plot of several, or a parameter with its slider; what stands there is
// kept in the address, so that it can be shared and comes back with the page.
import { complain, make } from './dom.js';
import { ParameterPanel } from './parameter.js';
import { placeOf, shortName } from './paths.js';
import { PlotPanel } from './plot.js';
import { TextPanel } from './text.js';

export class Panels {
  constructor({ place, link, field, about, onChange }) {
    Object.assign(this, { place, link, field, about, onChange });
    this.open = []; // {kind, names, panel, element}
  }

  text(name) { return this.add('text', [name], (body) => new TextPanel({ body, name, link: this.link, panels: this })); }
  plot(names) { return this.add('plot', names, (body) => new PlotPanel({ body, names, link: this.link, onNames: () => this.onChange() })); }
  parameter(name) {
    return this.add('parameter', [name], (body) => new ParameterPanel({ body, name, about: this.about(name), link: this.link }));
  }

  // The way of looking that fits a name.
  choose(name, kind) {
    if (kind === 'parameter') return this.parameter(name);
    if (kind === 'timing') return this.plot([`${name}.mean`]);
    if (kind.startsWith('response')) {
      return this.link.ask(`dr ${name} once`).then((lines) => lines.filter((l) => l.text).forEach((l) => complain(`${l.id}: ${l.text}`))).catch(complain);
    }
    return this.text(name);
  }

  // A number goes into the plot that was made last if `together`.
  plotValue(name, together) {
    const last = this.open.findLast(({ kind }) => kind === 'plot');
    if (together && last) last.panel.add(name);
    else this.plot([name]);
  }

  add(kind, names, makePanel) {
    const there = this.open.find((entry) => entry.kind === kind && entry.names().join() === names.join());
    if (there) {
      there.element.scrollIntoView({ block: 'nearest' });
      return there.panel;
    }
    const body = make('div', { className: 'body' }), buttons = make('span');
    const title = make('b', { title: names.join(', ') }, make('bdi', { textContent: names.map(shortName).join(', ') }));
    const close = make('button', { textContent: '×', title: 'Close' });
    const element = make('article', { className: `panel ${kind}` }, make('header', {}, title, buttons, close), body);
    element.dataset.name = names[0];
    this.place.append(element);
    const panel = makePanel(body);
    const entry = { kind, panel, element, names: () => panel.names ?? names };
    buttons.append(...(panel.buttons ?? []));
    close.onclick = () => this.remove(entry);
    this.open.push(entry);
    this.onChange();
    return panel;
  }

  remove(entry) {
    entry.panel.end();
    entry.element.remove();
    this.open = this.open.filter((other) => other !== entry);
    this.onChange();
  }

  showsOnField(name, value) { return placeOf(value) && this.field.follows(name); }
  names() { return this.open.flatMap((entry) => entry.names()); }

  // "text=representation:BallPos&plot=a,b" and back.
  state() { return this.open.map(({ kind, names }) => [kind, names().join(',')]); }
  restore(kind, names) {
    if (kind === 'text') names.forEach((name) => this.text(name));
    if (kind === 'plot') this.plot(names);
    if (kind === 'parameter') names.forEach((name) => this.parameter(name));
  }
}
