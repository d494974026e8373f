// Turns frames that come 25 times a second into a picture at any time: each frame is reached smoothly within the
// usual time between two of them.
import { blendPoses } from './frame.js';

const jump = 1.5; // what moved further between two frames did not run there [m]

function far(a, b) {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) > jump;
}

export class Motion {
  constructor() {
    this.interval = 40;
    this.arrived = 0;
    this.frame = null; // the last one that came
    this.shown = null; // what is shown now: ball and robots with poses
  }

  take(frame, now) {
    if (this.frame) {
      const passed = Math.min(now - this.arrived, 400);
      this.interval += 0.15 * (passed - this.interval);
    }
    this.arrived = now;
    const before = this.shown;
    this.frame = frame;
    const sameRobots = before && before.robots.length === frame.robots.length &&
      frame.robots.every((r, i) => {
        const b = before.robots[i];
        return b.side === r.side && b.unum === r.unum && b.type === r.type && b.poses.length === r.poses.length;
      });
    this.from = {
      ball: before && !far(before.ball, frame.ball) ? before.ball.slice() : frame.ball.slice(),
      robots: frame.robots.map((r, i) =>
        sameRobots && r.poses.length && !far(before.robots[i].poses, r.poses) ? before.robots[i].poses.slice() : r.poses.slice()),
    };
    if (!sameRobots) {
      this.shown = { ball: frame.ball.slice(), robots: frame.robots.map((r) => ({ ...r, poses: r.poses.slice() })) };
    }
    return !sameRobots;
  }

  advance(now) {
    if (!this.frame) return null;
    const share = Math.min(1, (now - this.arrived) / Math.max(10, this.interval));
    blendPoses(this.shown.ball, this.from.ball, this.frame.ball, share);
    this.frame.robots.forEach((r, i) => {
      blendPoses(this.shown.robots[i].poses, this.from.robots[i], r.poses, share);
    });
    return this.shown;
  }
}
