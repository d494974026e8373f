// Numbers over the last seconds, several in one plot.
import uPlot from '../../uplot/uPlot.esm.js';
import { make } from './dom.js';
import { shortName } from './paths.js';

const colours = ['#8fc1ff', '#ffb05a', '#8fe0a8', '#ff8a7a', '#d7a8ff', '#ffe14d'];
const seconds = 20, most = 6, height = 150;

export class PlotPanel {
  constructor({ body, names, link, onNames }) {
    Object.assign(this, { body, link, onNames });
    this.names = [];
    this.watches = [];
    this.points = []; // [time, index of the value, value]
    this.error = make('div', { className: 'error' });
    this.more = make('input', { type: 'text', placeholder: '+ value', title: 'Another value into this plot; Enter', size: 8 });
    this.more.onkeydown = (event) => {
      if (event.key !== 'Enter' || !this.more.value.trim()) return;
      this.add(this.more.value.trim());
      this.more.value = '';
    };
    this.buttons = [this.more];
    this.begin = performance.now();
    for (const name of names) this.add(name, true);
    this.timer = setInterval(() => this.draw(), 100);
    this.observer = new ResizeObserver(() => this.chart?.setSize({ width: this.width(), height }));
    this.observer.observe(body);
  }

  // Of a log its own time, else since the plot was opened [s].
  now() { return this.link.moment ?? (performance.now() - this.begin) / 1000; }

  width() { return Math.max(120, this.body.clientWidth - 4); }

  add(name, silent) {
    if (this.names.length >= most || this.names.includes(name)) return;
    const index = this.names.push(name) - 1;
    this.watches.push(this.link.watch(name, '0.04s', (value) => this.take(index, name, value), (error) => { this.error.textContent = error; }));
    this.build();
    if (!silent) this.onNames();
  }

  take(index, name, value) {
    const number = typeof value === 'boolean' ? Number(value) : value;
    if (typeof number !== 'number' && number !== null) {
      this.error.textContent = `${shortName(name)} is no number; plot a part of it`;
      return;
    }
    const now = this.now();
    // Back in a log: what came behind that moment is not yet.
    if (this.points.length && now < this.points.at(-1)[0] - 1e-6) this.points = this.points.filter(([time]) => time < now);
    this.points.push([now, index, number]);
  }

  build() {
    this.chart?.destroy();
    const axis = { stroke: '#a9b6c0', grid: { stroke: '#26323c' }, ticks: { stroke: '#26323c' }, font: '11px system-ui' };
    this.chart = new uPlot({
      width: this.width(), height, pxAlign: 0, cursor: { drag: { x: false, y: false } },
      scales: { x: { time: false } },
      axes: [{ ...axis, size: 24 }, { ...axis, size: 52 }],
      series: [{ label: 's' }, ...this.names.map((name, i) => ({ label: shortName(name), stroke: colours[i], width: 1.5, spanGaps: true, points: { show: false } }))],
    }, [[], ...this.names.map(() => [])], this.body);
    this.body.append(this.error);
  }

  draw() {
    const end = this.now();
    this.points = this.points.filter(([time]) => time > end - seconds);
    const data = [this.points.map(([time]) => time), ...this.names.map((_, i) => this.points.map(([, index, value]) => (index === i ? value : undefined)))];
    this.chart.setData(data);
  }

  end() {
    clearInterval(this.timer);
    this.observer.disconnect();
    this.watches.forEach((watch) => watch.end());
    this.chart?.destroy();
  }
}
