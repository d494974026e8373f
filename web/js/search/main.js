// Puts the page of a search together: what its server says, each message by what it is of.
import { Connection } from '../connection.js';
import { Curves } from './curves.js';
import { Film } from './film.js';
import { Numbers } from './numbers.js';
import { Parameters } from './parameters.js';
import { Workers } from './workers.js';

const $ = (id) => document.getElementById(id);
const curves = new Curves({ costs: $('costs'), sigma: $('sigma'), logarithmic: $('logCosts') });
const film = new Film($('view'));
const numbers = new Numbers($('numbers'));
const parameters = new Parameters({ place: $('parameterList'), filter: $('filter'), moved: $('moved') });
const workers = new Workers({ place: $('workerList'), trouble: $('trouble') });
const state = { study: null, status: null };

const take = {
  study(message) {
    state.study = message;
    const options = Object.entries(message.options).map(([key, value]) => `${key} ${value}`).join(', ');
    $('what').textContent = message.task;
    $('options').textContent = `${options ? `${options}; ` : ''}${message.optimizer}, seed ${message.seed}; ${message.file}, results in ${message.folder}`;
    document.title = `${message.task}: Plumbline`;
    numbers.limits(message);
    parameters.study(message.parameters);
    film.expect(message.task);
  },
  status(message) {
    state.status = message;
    numbers.take(message);
    workers.take(message);
    $('state').textContent = message.stop ? `over: ${message.stop}` : message.live ? 'searching' : 'not searching';
    $('state').classList.toggle('over', !message.live);
  },
  curve({ points }) {
    curves.take(points);
    numbers.curve(points);
  },
  found({ best, favourite }) { parameters.take(best, favourite); },
  geometry({ types }) { film.setTypes(types); },
  film(message) { film.take(message); },
  noFilm({ why }) { film.none(why); },
};

new Connection({
  onState(open) {
    $('online').textContent = open ? 'connected' : 'connection lost; trying again';
    $('online').classList.toggle('lost', !open);
  },
  onMessage: (message) => take[message.kind]?.(message),
});

// For tests and the console.
window.plumbline = { state: () => ({ ...state, points: curves.points.length, parameters: parameters.rows.size, film: film.state() }), film };
