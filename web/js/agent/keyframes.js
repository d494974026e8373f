// A keyframe motion while it is edited: keyframes as {from, time, settle, joints: {name: degrees}}, undo, and what the
// robot looks like at a time. Knows no page.
const most = 200; // steps that can be undone

const copy = (keyframes) => keyframes.map((k) => ({ ...k, joints: { ...k.joints } }));
export const round = (value, step) => Number((Math.round(value / step) * step).toFixed(3));

export class KeyframeMotion {
  // file: what `get motion:NAME` says.
  constructor(name, file) {
    this.name = name;
    this.take(file);
    this.keyframes = copy(this.saved);
    this.past = [];
    this.future = [];
  }

  take(file) {
    this.revision = file.revision;
    this.restStays = file.restStays;
    this.saved = file.keyframes.map(({ from, time, settle, joints }) => ({ from, time, settle, joints: Object.fromEntries(joints.map(({ joint, degrees }) => [joint, degrees])) }));
  }

  get changed() { return JSON.stringify(this.keyframes) !== JSON.stringify(this.saved); }

  // Changes go through here, so that they can be undone. What has the same mark as the change before is one with it.
  change(edit, mark = null) {
    const before = copy(this.keyframes);
    edit(this.keyframes);
    if (JSON.stringify(before) === JSON.stringify(this.keyframes)) return false;
    if (!mark || mark !== this.mark) this.past = [...this.past, before].slice(-most);
    this.mark = mark;
    this.future = [];
    return true;
  }

  undo() { this.step(this.past, this.future); }
  redo() { this.step(this.future, this.past); }
  step(from, to) {
    if (!from.length) return;
    to.push(copy(this.keyframes));
    this.keyframes = from.pop();
    this.mark = null;
  }

  // The joints that some keyframe names.
  named() { return new Set(this.keyframes.flatMap((k) => Object.keys(k.joints))); }

  setJoint(index, joint, degrees, mark) {
    return this.change((all) => {
      // Where nothing may be left out, a joint that is new is in every keyframe.
      const everywhere = !this.restStays && !this.named().has(joint);
      for (const keyframe of everywhere ? all : [all[index]]) keyframe.joints[joint] = degrees;
    }, mark);
  }

  leaveOut(index, joint) {
    return this.change((all) => {
      for (const keyframe of this.restStays ? [all[index]] : all) delete keyframe.joints[joint];
    });
  }

  // A copy behind this one, which the file knows nothing of yet.
  insert(index) {
    return this.change((all) => all.splice(index + 1, 0, { from: -1, time: all[index].time || 0.2, settle: 0, joints: { ...all[index].joints } }));
  }

  remove(index) { return this.keyframes.length > 1 && this.change((all) => all.splice(index, 1)); }

  move(index, by) {
    const to = index + by;
    return to >= 0 && to < this.keyframes.length && this.change((all) => all.splice(to, 0, ...all.splice(index, 1)));
  }

  // When each keyframe is reached, without waiting [s].
  times() {
    let sum = 0;
    return this.keyframes.map(({ time }) => (sum += time));
  }
  get seconds() { return this.times().at(-1) ?? 0; }

  // All joints' degrees when keyframe `index` is reached; begin: before the first.
  posture(index, begin) {
    return Object.assign({ ...begin }, ...this.keyframes.slice(0, index + 1).map((k) => k.joints));
  }

  postureAt(seconds, begin) {
    const times = this.times(), index = times.findIndex((time) => seconds < time);
    if (index < 0) return this.posture(this.keyframes.length - 1, begin);
    const from = this.posture(index - 1, begin), to = this.posture(index, begin);
    const share = 1 - (times[index] - seconds) / this.keyframes[index].time;
    return Object.fromEntries(Object.keys(to).map((joint) => [joint, (from[joint] ?? to[joint]) + share * (to[joint] - (from[joint] ?? to[joint]))]));
  }

  // What a keyframe asks of joints that they cannot do: [{joint, needs, speed}] in degrees a second.
  tooFast(index, parts, begin) {
    const { time } = this.keyframes[index], from = this.posture(index - 1, begin), to = this.posture(index, begin);
    return parts.filter(({ joint, speed }) => joint && to[joint] !== undefined && from[joint] !== undefined && speed > 0 &&
      Math.abs(to[joint] - from[joint]) > 1.02 * speed * Math.max(time, 0.02))
      .map(({ joint, speed }) => ({ joint, needs: Math.abs(to[joint] - from[joint]) / Math.max(time, 0.02), speed }));
  }

  // As `set` wants them.
  text() {
    const angles = (joints) => Object.entries(joints).map(([joint, degrees]) => `{"${joint}" ${degrees.toFixed(3)}}`).join(' ');
    return `{${this.keyframes.map((k) => `{${k.from} ${k.time.toFixed(3)} ${k.settle.toFixed(3)} {${angles(k.joints)}}}`).join(' ')}}`;
  }
  fileText(file) { return `{${JSON.stringify(file)} "${this.revision}" "" ${this.restStays} ${this.text()}}`; }
  draftText(first, last) { return `{"${this.name}" ${first} ${last} ${this.text()}}`; }
}
