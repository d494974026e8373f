// Turns frames, some 25 a second, into a picture at any time. It shows the scene a little late, always between two frames
// that came: nothing is guessed beyond them, and what was shown once decides nothing.
import { blendPoses } from './frame.js';

const jump = 1.5; // what moved further between two frames did not run there [m]
const longest = 250; // between two frames; more is a pause of the stream [ms]
const most = 100; // frames kept

function far(a, b) {
  return Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) > jump;
}

function sameRobot(a, b) {
  return a.side === b.side && a.unum === b.unum && a.type === b.type && a.poses.length === b.poses.length;
}

function sameRoster(a, b) {
  return a.length === b.length && a.every((robot, i) => sameRobot(robot, b[i]));
}

export class Motion {
  constructor() {
    this.interval = 40; // usual time between two frames [ms]
    this.frames = []; // with the time at which each is due, `at`, rising
    this.waiting = []; // came since the last picture, with the time at which they were read
    this.shown = null; // ball and robots with poses; `robots` is a new list when others are there
  }

  get frame() { return this.waiting.at(-1)?.frame ?? this.frames.at(-1)?.frame ?? null; }

  // A frame was read; `now` is of the same clock as advance()'s.
  take(frame, now) {
    this.waiting.push({ frame, at: now });
    if (this.waiting.length > most) this.waiting.shift();
  }

  // While a slow picture is drawn the frames queue up and are then read all at once: they are spread over the time since
  // the last one, as they were sent.
  date(now) {
    const count = this.waiting.length;
    const before = Math.min(this.frames.at(-1)?.at ?? now, now);
    this.waiting.forEach((entry, i) => {
      entry.at = Math.max(before, Math.min(entry.at, before + ((now - before) * (i + 1)) / count));
      const last = this.frames.at(-1);
      if (last) this.interval += 0.15 * (Math.min(entry.at - last.at, longest) - this.interval);
      this.frames.push(entry);
    });
    this.waiting = [];
  }

  // What to show at a time; null before the first frame.
  advance(now) {
    this.date(now);
    if (!this.frames.length) return null;
    const delay = Math.max(10, 1.25 * this.interval), time = now - delay;
    while (this.frames.length > most || (this.frames.length > 1 && this.frames[1].at <= time)) this.frames.shift();
    const [from, to] = [this.frames[0], this.frames[1] ?? this.frames[0]];
    // After a pause of the stream the scene stays until the new frame is one delay away.
    const span = Math.min(to.at - from.at, delay);
    const share = span > 0 ? Math.min(1, Math.max(0, 1 - (to.at - time) / span)) : 1;
    this.blend(from.frame, to.frame, share);
    return this.shown;
  }

  blend(from, to, share) {
    if (!this.shown || !sameRoster(this.shown.robots, to.robots)) {
      this.shown = { ball: to.ball.slice(), robots: to.robots.map((r) => ({ ...r, poses: r.poses.slice() })) };
    }
    const between = (out, a, b) => blendPoses(out, far(a, b) ? b : a, b, share);
    between(this.shown.ball, from.ball, to.ball);
    const same = sameRoster(from.robots, to.robots);
    to.robots.forEach((robot, i) => {
      const shown = this.shown.robots[i];
      shown.torso = robot.torso;
      if (robot.poses.length) between(shown.poses, same ? from.robots[i].poses : robot.poses, robot.poses);
    });
  }
}
