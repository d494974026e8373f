// The view of the formation: for a ball anywhere, where the players without it stand. Ball and places are dragged; saved, they are in
// config/formation.yaml, and the players take them over.
import { complain } from './dom.js';
import { FormationModel } from './formation.js';
import { Pitch } from './pitch.js';

const $ = (id) => document.getElementById(id);
const snap = 0.7; // a ball this near to one of the table is there [m]

export class Coach {
  constructor({ link, onOpen }) {
    Object.assign(this, { link, onOpen, ball: [0, 0] });
    const on = (id, run) => { $(id).onclick = run; };
    on('coachUndo', () => this.turn('undo'));
    on('coachRedo', () => this.turn('redo'));
    on('coachSave', () => this.save());
    on('coachDiscard', () => this.read().catch(complain));
    addEventListener('beforeunload', (event) => { if (this.model?.changed) event.preventDefault(); });
    document.addEventListener('keydown', (event) => this.key(event));
  }

  get isOpen() { return document.body.classList.contains('coaching'); }

  offer(there) { $('toFormation').hidden = !there; }

  close() {
    document.body.classList.remove('coaching');
    this.onOpen();
  }

  async open() {
    document.body.classList.add('coaching');
    try {
      if (!this.pitch) {
        this.dimensions = (await this.link.ask('get representation:FieldDimensions'))[0].value;
        this.pitch = new Pitch({ place: $('coachField'), onDrag: (key, to) => this.drag(key, to), onDragged: () => { if (this.model) this.model.mark = null; } });
        this.pitch.field(this.dimensions);
      }
      if (!this.model) await this.read();
    } catch (error) { complain(error); }
    this.onOpen();
  }

  async read() {
    const file = (await this.link.ask('get formation'))[0].value;
    this.path = file.file;
    this.refused = file.comment;
    this.notice = '';
    this.model = file.comment ? null : new FormationModel(file);
    this.show();
  }

  inField([x, y]) {
    const { length, width } = this.dimensions, within = (value, most) => Math.max(-most, Math.min(most, value));
    return [within(x, length / 2), within(y, width / 2)];
  }

  drag(key, to) {
    const { model } = this, at = this.inField(to);
    if (key === 'ball') this.ball = model.nearestBall(at, snap) ?? at;
    else if (model.move(Number(key), this.ball, at, `${key} ${this.ball}`)) this.refused = this.notice = '';
    this.show();
  }

  turn(which) {
    this.model?.[which]();
    this.refused = this.notice = '';
    this.show();
  }

  key(event) {
    if (!this.isOpen || !(event.ctrlKey || event.metaKey)) return;
    if (event.key === 's') this.save();
    else if (event.key === 'z') this.turn(event.shiftKey ? 'redo' : 'undo');
    else return;
    event.preventDefault();
  }

  show() {
    const { model, pitch, ball } = this;
    if (model && pitch) {
      const dots = model.ballX.flatMap((x) => model.ballY.flatMap((y) => (y ? [[x, y], [x, -y]] : [[x, y]])));
      pitch.dots(dots);
      pitch.drop((key) => key === 'ball' || Number(key) < model.places.length);
      pitch.thing('ball', { at: ball, label: '', name: '', kind: 'ball', moves: true });
      model.places.forEach(({ name }, k) => pitch.thing(`${k}`, { at: model.at(k, ball), label: k + 1, name, kind: 'place', moves: true }));
      const on = model.nearestBall(ball, 1e-6);
      $('coachBall').textContent = `ball at ${ball.map((v) => v.toFixed(1)).join(', ')} m${on ? ', a ball of the table' : ': between balls of the table, of which the nearest change'}`;
    }
    $('coachUndo').disabled = !model?.past.length;
    $('coachRedo').disabled = !model?.future.length;
    $('coachSave').disabled = !model?.changed || !this.link.online;
    $('coachDiscard').disabled = Boolean(model) && !model.changed && !this.refused;
    $('coachState').textContent = this.refused || this.notice || (model?.changed ? 'not saved yet' : `as in ${this.path}`);
    $('coachState').className = this.refused ? 'error' : model?.changed ? 'unsaved' : '';
  }

  async save() {
    const { model } = this;
    if (!model?.changed) return;
    try {
      await this.link.ask(`set formation ${model.fileText(this.path)}`);
      model.take((await this.link.ask('get formation'))[0].value);
      await this.link.ask('reload formation');
      this.refused = '';
      this.notice = 'saved, and the player has it';
    } catch (error) {
      this.refused = /changed by somebody else/.test(error.message) ? 'Not saved: somebody else has changed the file. Discard what is here to see it.' : error.message;
    }
    this.show();
  }
}
