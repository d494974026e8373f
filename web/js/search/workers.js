// Who evaluates, and what went wrong.
import { make } from '../agent/dom.js';
import { duration } from './numbers.js';

const late = 30; // with one trial [s]

export class Workers {
  constructor({ place, trouble }) { Object.assign(this, { place, trouble }); }

  take({ live, of = [], counts = {}, dropped = 0, lost = 0, hung = 0, again = 0, not_numbers: notNumbers = 0, given_up: givenUp = 0 }) {
    const head = make('tr', {}, ...['worker', 'does', 'evaluations answered', 'for'].map((textContent) => make('th', { textContent })));
    this.place.replaceChildren(...(of.length ? [head] : []), ...of.map(({ name, busy, answers, seconds }) => make('tr', {},
      make('td', { textContent: name }), make('td', { className: !busy ? 'idle' : seconds > late ? 'late' : 'busy', textContent: busy ? 'evaluates' : 'waits' }),
      make('td', { textContent: answers }), make('td', { textContent: busy ? duration(seconds) : '' }))));
    const problems = [[counts.wrong, 'answers refused'], [dropped, 'clients dropped'], [lost, 'trials lost with a worker'], [hung, 'workers hung'],
      [again, 'answered twice'], [counts.doubted, 'answers doubted'], [notNumbers, 'costs that are no number'], [givenUp, 'trials given up']];
    const wrong = problems.filter(([n]) => n > 0).map(([n, what]) => `${n} ${what}`).join(', ');
    this.trouble.textContent = live ? (of.length ? wrong || 'Nothing was refused or lost.' : `No worker is there: start bin/optworker. ${wrong}`) : wrong || 'The search does not run; this is what is in its folder.';
  }
}
