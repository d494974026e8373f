// Edits a motion of config/motions: sliders for a keyframe's joints, its time, and a robot that shows what they say.
import { complain, make } from './dom.js';
import { Drafts } from './drafts.js';
import { Figures } from './figures.js';
import { Joints } from './joints.js';
import { KeyframeMotion, round } from './keyframes.js';
import { Timeline } from './timeline.js';
import { Trial } from './trial.js';

const $ = (id) => document.getElementById(id);

export class Editor {
  constructor({ link, motions, onOpen }) {
    Object.assign(this, { link, onOpen });
    this.trial = new Trial({ link, motions, onState: (text) => { $('editorPlaying').textContent = text; } });
    this.drafts = new Drafts();
    this.chosen = 0;
    this.names = [];
    addEventListener('beforeunload', (event) => { if (this.motion?.changed) event.preventDefault(); });
    document.addEventListener('keydown', (event) => this.key(event));
  }

  get isOpen() { return document.body.classList.contains('editing'); }

  offer(names) {
    const key = JSON.stringify(names);
    if (key === this.offered) return;
    this.offered = key;
    this.names = names;
    $('toMotion').hidden = !names.length;
    this.listNames();
  }

  listNames() {
    $('editorName').replaceChildren(...this.names.map((name) => make('option', { value: name, textContent: this.drafts.has(name) ? `${name} (unsaved)` : name })));
    if (this.motion) $('editorName').value = this.motion.name;
  }

  close() {
    document.body.classList.remove('editing');
    this.onOpen();
  }

  async open(name = this.motion?.name ?? this.names[0]) {
    if (!name) return;
    document.body.classList.add('editing');
    try {
      await this.build();
      await this.read(name);
    } catch (error) { complain(error); }
    this.onOpen();
  }

  async build() {
    if (this.figures) return;
    this.parts = (await this.link.ask('get module:MotionEditor:robot'))[0].value;
    const { angles } = (await this.link.ask('get representation:JointData'))[0].value;
    this.begin = Object.fromEntries(this.parts.filter(({ joint }) => joint).map(({ joint, number }) => [joint, (angles[number] * 180) / Math.PI]));
    this.figures = new Figures($('editorView'), this.parts);
    this.joints = new Joints({
      place: $('editorJoints'), parts: this.parts,
      onSet: (set, mark) => this.change(() => set.map(([joint, degrees]) => this.motion.setJoint(this.chosen, joint, degrees, mark)), true),
      onLeaveOut: (joint) => this.change(() => this.motion.leaveOut(this.chosen, joint)),
    });
    this.timeline = new Timeline({
      place: $('editorTimeline'), onChoose: (index) => this.choose(index), onTime: (seconds) => this.goTo(seconds),
      onDrag: (index, time) => this.drag(index, time), onDragged: () => { this.motion.mark = null; },
    });
    this.wire();
    let torso = null;
    this.link.watch('representation:TorsoPose.T_ground_torso', '0.1s', (pose) => { torso = pose; });
    this.link.watch('representation:FKModel.T_torso_link', '0.1s', (links) => { if (torso && this.isOpen) this.figures.now(links, torso); });
  }

  wire() {
    const on = (id, run) => { $(id).onclick = run; };
    on('editorPlay', () => this.play(0));
    on('editorFrom', () => this.play(this.chosen));
    on('editorHold', () => this.hold());
    on('editorBack', () => this.trial.handBack());
    on('editorAdd', () => this.change(() => this.motion.insert(this.chosen)) && this.choose(this.chosen + 1));
    on('editorRemove', () => this.change(() => this.motion.remove(this.chosen)) && this.choose(Math.min(this.chosen, this.motion.keyframes.length - 1)));
    on('editorEarlier', () => this.change(() => this.motion.move(this.chosen, -1)) && this.choose(this.chosen - 1));
    on('editorLater', () => this.change(() => this.motion.move(this.chosen, 1)) && this.choose(this.chosen + 1));
    on('editorUndo', () => this.change(() => { this.motion.undo(); return true; }));
    on('editorRedo', () => this.change(() => { this.motion.redo(); return true; }));
    on('editorSave', () => this.save());
    on('editorDiscard', () => this.discard());
    on('editorKeep', () => this.keepMine());
    $('editorName').onchange = () => this.open($('editorName').value);
    $('editorTimeOf').onchange = () => this.number('time', $('editorTimeOf'));
    $('editorSettle').onchange = () => this.number('settle', $('editorSettle'));
    $('editorLie').onchange = () => { this.figures.lie($('editorLie').value); this.pose(); };
  }

  number(key, input) {
    const value = Math.max(0, Number(input.value) || 0);
    this.change(() => this.motion.change((all) => { all[this.chosen][key] = round(value, 0.001); }));
  }

  key(event) {
    if (!this.isOpen || event.target.matches?.('input[type="text"], input[type="number"], input[type="search"]')) return;
    const command = event.ctrlKey || event.metaKey;
    if (command && event.key === 's') this.save();
    else if (command && event.key === 'z') $(event.shiftKey ? 'editorRedo' : 'editorUndo').click();
    else if (event.key === ' ' && event.target.tagName !== 'BUTTON') this.play(0);
    else return;
    event.preventDefault();
  }

  async file(name) { return (await this.link.ask(`get motion:${name}`))[0].value; }

  async read(name) {
    const file = await this.file(name);
    this.path = file.file;
    this.motion = new KeyframeMotion(name, file);
    this.chosen = 0;
    this.refused = file.comment;
    const draft = this.drafts.get(name);
    this.conflict = false;
    if (draft && JSON.stringify(draft.keyframes) !== JSON.stringify(this.motion.saved)) {
      this.motion.keyframes = draft.keyframes;
      this.motion.revision = draft.revision;
      this.conflict = draft.revision !== file.revision;
      this.notice = `Unsaved changes of ${draft.when} are back.`;
    } else this.notice = '';
    this.listNames();
    this.choose(0);
  }

  choose(index) {
    this.chosen = index;
    this.time = this.motion.times()[index] ?? 0;
    this.show();
  }

  goTo(seconds) {
    this.time = seconds;
    const index = this.motion.times().findIndex((time) => seconds <= time + 1e-9);
    this.chosen = index < 0 ? this.motion.keyframes.length - 1 : index;
    this.show();
  }

  drag(index, time) {
    const before = this.motion.times()[index] - this.motion.keyframes[index].time;
    this.change(() => this.motion.change((all) => { all[index].time = Math.max(0, round(time - before, 0.01)); }, `time ${index}`));
    this.choose(index);
  }

  // edit() says whether it changed something.
  change(edit, still) {
    if (![edit()].flat().some(Boolean)) return false;
    this.refused = '';
    if (!this.conflict) this.notice = '';
    if (this.motion.changed) this.drafts.put(this.motion);
    else this.drafts.drop(this.motion.name);
    this.chosen = Math.min(this.chosen, this.motion.keyframes.length - 1);
    this.time = this.motion.times()[this.chosen];
    this.show();
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.check(), still ? 120 : 0);
    return true;
  }

  // Asks the agent whether the motion is possible; where the robot holds the posture it takes the new one.
  async check() {
    const motion = this.motion;
    try {
      if (this.trial.holding) await this.trial.hold(motion, this.chosen);
      else await this.trial.give(motion, 0, motion.keyframes.length - 1);
      this.refused = '';
    } catch (error) { this.refused = error.message; }
    if (motion === this.motion) this.status();
  }

  pose() {
    const { motion, time } = this;
    this.figures.wanted(motion.postureAt(time, this.begin));
    this.timeline.at(time);
  }

  show() {
    const keyframe = this.motion.keyframes[this.chosen];
    this.joints.show(this.motion.posture(this.chosen, this.begin), keyframe.joints);
    const warnings = this.motion.keyframes.map((_, i) => (i ? this.motion.tooFast(i, this.parts, this.begin) : [])
      .map(({ joint, needs, speed }) => `${joint}: ${needs.toFixed(0)} degrees/s asked, it can ${speed.toFixed(0)}`).join('\n'));
    this.timeline.show(this.motion, this.chosen, warnings);
    $('editorWhich').textContent = `keyframe ${this.chosen + 1} of ${this.motion.keyframes.length}`;
    for (const [id, key] of [['editorTimeOf', 'time'], ['editorSettle', 'settle']])
      if (document.activeElement !== $(id)) $(id).value = keyframe[key];
    $('editorEarlier').disabled = this.chosen === 0;
    $('editorLater').disabled = this.chosen === this.motion.keyframes.length - 1;
    $('editorRemove').disabled = this.motion.keyframes.length < 2;
    this.pose();
    this.status();
  }

  status() {
    const { changed, past, future } = this.motion;
    $('editorUndo').disabled = !past.length;
    $('editorRedo').disabled = !future.length;
    $('editorSave').disabled = !changed || this.conflict || !this.link.online;
    $('editorDiscard').disabled = !changed;
    $('editorKeep').hidden = !this.conflict;
    const note = this.conflict ? `${this.notice || 'Not saved.'} Somebody else has changed the file: discard what is here, or keep it and save it over theirs.` : this.notice;
    $('editorState').textContent = this.refused || note || (changed ? 'not saved yet' : `as in ${this.path}`);
    $('editorState').className = this.refused ? 'error' : changed ? 'unsaved' : '';
    document.title = `${changed ? '• ' : ''}${this.motion.name}: Plumbline`;
  }

  async play(first) {
    try {
      await this.trial.play(this.motion, first);
      this.refused = '';
    } catch (error) { this.refused = error.message; }
    this.status();
  }

  async hold() {
    try {
      if (this.trial.holding) await this.trial.handBack();
      else await this.trial.hold(this.motion, this.chosen);
    } catch (error) { this.refused = error.message; }
    $('editorHold').classList.toggle('on', this.trial.holding);
    this.status();
  }

  async save() {
    const { motion } = this, { orders } = this.trial;
    if (!motion.changed) return;
    try {
      await this.link.ask(`set motion:${motion.name} ${motion.fileText(this.path)}`);
    } catch (error) {
      this.refused = error.message;
      if (/changed by somebody else/.test(error.message)) {
        this.conflict = true;
        this.refused = '';
        this.notice = '';
      }
      return this.status();
    }
    this.drafts.drop(motion.name);
    const file = await this.file(motion.name);
    motion.take(file);
    motion.keyframes.forEach((keyframe, i) => { keyframe.from = i; });
    motion.past = [];
    motion.future = [];
    this.notice = 'saved';
    this.conflict = false;
    this.listNames();
    this.show();
    if (orders === this.trial.orders) await this.play(0); // nothing else was wanted since the click
  }

  discard() {
    this.drafts.drop(this.motion.name);
    this.listNames();
    this.read(this.motion.name).catch(complain);
  }

  // The file is another one now: what was edited goes over it.
  async keepMine() {
    const { motion } = this, file = await this.file(motion.name);
    const keyframes = motion.keyframes.map((k) => ({ ...k, from: k.from < file.keyframes.length ? k.from : -1 }));
    motion.take(file);
    motion.keyframes = keyframes;
    this.conflict = false;
    this.refused = '';
    this.notice = '';
    this.show();
  }
}
