// The robot tries what is edited: under the name "(draft)" it asks for the motion as for any other.
const draft = '(draft)', longest = 60000; // bytes of a command, below the server's bound
const asks = [['specialAction', `"${draft}"`], ['motion', 'specialAction']];

export class Trial {
  constructor({ link, motions, onState }) {
    Object.assign(this, { link, motions, onState });
    this.holding = false;
    this.orders = 0; // what was wanted last counts, whatever is still under way
    link.watch('representation:MotionSelection.specialAction', '0.1s', (name) => this.took(name), () => {});
  }

  took(name) {
    this.playing = name === draft;
    // It begins anew as long as it is asked for; once is enough.
    if (this.playing && this.once) {
      this.once = false;
      this.motions.ask([['motion', 'stand']], 'stand');
    }
    this.onState(this.playing ? (this.holding ? 'the robot holds this posture' : 'the robot plays it') : name ? `the robot plays ${name}` : '');
  }

  async give(motion, first, last, text = motion.draftText(first, last)) {
    if (text.length > longest) throw new Error('too many keyframes for the page; edit the file');
    await this.link.ask(`set module:MotionEditor:draft ${text}`);
  }

  async play(motion, first) {
    const order = ++this.orders;
    await this.give(motion, first, motion.keyframes.length - 1);
    if (order !== this.orders) return;
    this.holding = false;
    this.once = true;
    await this.motions.ask(asks, motion.name);
  }

  // The posture alone, again and again, so that a slider that moves takes the robot with it.
  async hold(motion, index) {
    const joints = Object.entries(motion.posture(index, {})).map(([joint, degrees]) => `{"${joint}" ${degrees.toFixed(3)}}`);
    const order = ++this.orders;
    await this.give(motion, 0, 0, `{"${motion.name}" 0 0 {{-1 0.2 0 {${joints.join(' ')}}}}}`);
    if (order !== this.orders) return;
    this.once = false;
    if (!this.holding) await this.motions.ask(asks, `${motion.name}, keyframe ${index + 1}`);
    this.holding = true;
  }

  async handBack() {
    ++this.orders;
    this.holding = this.once = false;
    await this.motions.handBack();
  }
}
