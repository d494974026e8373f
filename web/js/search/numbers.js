// How far a search is, in figures.
import { make } from '../agent/dom.js';

const count = (n) => (n ?? 0).toLocaleString('en').replaceAll(',', ' ');
const cost = (x) => (x === null || x === undefined ? '-' : Number(x).toPrecision(5));

export function duration(seconds) {
  if (!Number.isFinite(seconds)) return '-';
  const s = Math.round(seconds), h = Math.floor(s / 3600), m = Math.floor(s / 60) % 60;
  return h ? `${h} h ${m} min` : m ? `${m} min ${s % 60} s` : `${s} s`;
}

// What is left, from the pace since the server began.
export function left({ generation, runs, seconds, live }, { maxGenerations, maxRuns }, begin) {
  if (!live || !begin) return null;
  const time = seconds - begin.seconds;
  const byGenerations = maxGenerations ? (maxGenerations - generation) / (generation - begin.generation) : Infinity;
  const byRuns = maxRuns ? (maxRuns - runs) / (runs - begin.runs) : Infinity;
  const share = Math.min(byGenerations, byRuns);
  return share >= 0 && Number.isFinite(share) && time > 0 ? share * time : null;
}

export class Numbers {
  constructor(place) {
    this.place = place;
    this.study = {};
  }

  limits(study) { this.study = study; }

  curve(points) {
    this.start = points[0]?.[2];
    if (this.status) this.take(this.status);
  }

  take(status) {
    this.status = status;
    if (status.live && !this.begin) this.begin = { generation: status.generation, runs: status.runs, seconds: status.seconds };
    const rest = left(status, this.study, this.begin);
    const { maxGenerations } = this.study;
    const box = (value, name, wrong) => make('div', { className: wrong ? 'number wrong' : 'number' }, make('b', { textContent: value }), make('span', { textContent: name }));
    const figures = Object.entries(status.figures ?? {}).map(([name, value]) => box(cost(value), name));
    const bar = make('div', { id: 'bar' }, make('i'));
    if (maxGenerations) bar.firstChild.style.width = `${(100 * status.generation) / maxGenerations}%`;
    this.place.replaceChildren(
      box(cost(status.best), this.start ? `best cost; ${cost(this.start)} at first` : 'best cost'),
      box(maxGenerations ? `${count(status.generation)} / ${count(maxGenerations)}` : count(status.generation), 'generations'),
      box(count(status.runs), 'evaluations'),
      box(cost(status.sigma), 'step size'),
      ...(status.live ? [
        box(status.runs_per_second?.toFixed(1) ?? '-', 'evaluations a second'),
        box(`${status.busy} / ${status.workers}`, 'workers busy', status.workers === 0),
        box(rest === null ? '?' : duration(rest), 'left'),
        box(duration(status.seconds), 'since it began')] : []),
      ...figures, maxGenerations ? bar : '');
  }
}
