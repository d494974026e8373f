// Best, mean and step size over the evaluations. Costs that are not all above 0 have no logarithm: then they are as they are.
import uPlot from '../../uplot/uPlot.esm.js';

const axis = { stroke: '#a9b6c0', grid: { stroke: '#26323c' }, ticks: { stroke: '#26323c' }, font: '11px system-ui' };
const short = (u, values) => values.map((v) => (v === null ? '' : Math.abs(v) >= 1e5 || (v !== 0 && Math.abs(v) < 1e-3) ? v.toExponential(0) : String(Number(v.toPrecision(6)))));
const valueText = (u, value) => (value === null || value === undefined ? '-' : Number(value).toPrecision(5));

export class Curves {
  constructor({ costs, sigma, logarithmic }) {
    Object.assign(this, { costs, sigma, logarithmic });
    this.points = [];
    logarithmic.onchange = () => this.build();
    new ResizeObserver(() => this.resize()).observe(costs.parentElement);
  }

  take(points) {
    this.points = points.filter(([, , best]) => best !== null);
    const positive = this.points.every(([, , best, mean]) => best > 0 && (mean === null || mean > 0));
    if (!this.charts || positive !== this.positive) {
      this.positive = positive;
      this.logarithmic.disabled = !positive;
      this.build();
    } else this.draw();
  }

  size(place) { return { width: Math.max(200, place.clientWidth - 6), height: Math.max(90, place.clientHeight - 34) }; }
  resize() { this.charts?.forEach((chart, i) => chart.setSize(this.size(i ? this.sigma : this.costs))); }

  build() {
    this.charts?.forEach((chart) => chart.destroy());
    const chart = (place, distribution, series, label) => new uPlot({
      ...this.size(place), cursor: { drag: { x: true, y: false } }, scales: { x: { time: false }, y: { distr: distribution } },
      axes: [{ ...axis, size: 30, values: short }, { ...axis, size: 66, values: short, label, labelSize: 18, labelFont: '11px system-ui' }],
      series: [{ label: 'evaluations', value: valueText }, ...series.map((s) => ({ width: 1.6, points: { show: false }, value: valueText, ...s }))],
    }, [[], ...series.map(() => [])], place);
    const log = this.positive && this.logarithmic.checked ? 3 : 1;
    this.charts = [
      chart(this.costs, log, [{ label: 'mean of the generation', stroke: '#6f8494', width: 1 }, { label: 'best', stroke: '#8fc1ff', width: 2 }], 'cost'),
      chart(this.sigma, 3, [{ label: 'step size, in units of the first', stroke: '#ffb05a' }], 'step size'),
    ];
    this.draw();
  }

  draw() {
    const column = (i) => this.points.map((point) => point[i]);
    this.charts[0].setData([column(1), column(3), column(2)]);
    this.charts[1].setData([column(1), this.points.map((p) => (p[4] > 0 ? p[4] : null))]);
  }
}
