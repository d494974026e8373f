// A slider for each joint of the robot, over what the joint can do; left and right beside each other.
import { make } from './dom.js';
import { round } from './keyframes.js';

export class Joints {
  constructor({ place, parts, onSet, onLeaveOut }) {
    Object.assign(this, { parts: parts.filter(({ joint }) => joint), onSet, onLeaveOut });
    this.rows = new Map(); // by joint: {slider, number, cell}
    this.both = make('input', { type: 'checkbox', id: 'bothSides', checked: true });
    const joined = new Set();
    const rows = this.parts.flatMap((part) => {
      if (joined.has(part.joint)) return [];
      const other = this.parts.find(({ joint }) => joint === part.otherSide);
      joined.add(part.joint).add(part.otherSide);
      return [make('div', { className: 'joint' }, make('b', { textContent: other ? part.joint.slice(1) : part.joint }), this.cell(part), other ? this.cell(other) : make('span'))];
    });
    place.replaceChildren(
      make('div', { className: 'joint head' }, make('b', { textContent: 'degrees' }), make('span', { textContent: 'left' }), make('span', { textContent: 'right' })), ...rows,
      make('label', {}, this.both, ' a joint takes that of the other side with it, as in a mirror'));
  }

  cell({ joint, lower, upper }) {
    const low = Math.ceil(10 * lower - 1e-6) / 10, high = Math.floor(10 * upper + 1e-6) / 10;
    const slider = make('input', { type: 'range', min: low, max: high, step: 0.1, title: `${joint}: ${low} to ${high} degrees` });
    const number = make('input', { type: 'number', min: low, max: high, step: 0.1, set: { 'aria-label': joint } });
    const out = make('button', { textContent: '×', title: 'Leave it out: it stays where the keyframe before put it' });
    slider.oninput = () => this.set(joint, Number(slider.value), `slide ${joint}`);
    slider.onchange = () => this.set(joint, Number(slider.value), null);
    number.onchange = () => { if (number.value !== '') this.set(joint, Number(number.value), null); };
    out.onclick = () => this.onLeaveOut(joint);
    const cell = make('span', { className: 'cell' }, slider, number, out);
    cell.dataset.joint = joint;
    this.rows.set(joint, { slider, number, cell });
    return cell;
  }

  set(joint, degrees, mark) {
    const part = this.parts.find((p) => p.joint === joint);
    const set = [[joint, degrees]];
    if (this.both.checked && part.otherSide && this.rows.has(part.otherSide)) set.push([part.otherSide, round(part.mirrorSign * degrees, 0.001)]);
    this.onSet(set, mark);
  }

  // own: what the keyframe itself names.
  show(posture, own) {
    for (const [joint, { slider, number, cell }] of this.rows) {
      const value = posture[joint] ?? 0;
      cell.classList.toggle('rests', own[joint] === undefined);
      if (document.activeElement !== slider || Number(slider.value) !== value) slider.value = value;
      if (document.activeElement !== number) number.value = round(value, 0.1);
    }
  }
}
