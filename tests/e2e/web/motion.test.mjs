// What the page shows between frames: node --test tests/e2e/web/motion.test.mjs
import assert from 'node:assert/strict';
import test from 'node:test';
import { Motion } from '../../../web/js/motion.js';

// One robot of a torso and an arm that swings beside it, and a ball; i counts cycles of 40 ms.
function frame(i, { unum = 1, jump = 0 } = {}) {
  const x = 0.03 * i + jump, arm = 0.3 * Math.sin(0.8 * i);
  const poses = Float32Array.from([x, 0, 0.4, 0, 0, 0, 1, x + arm, 0.1, 0.5, 0, 0, Math.sin(arm), Math.cos(arm)]);
  return { time: 0.04 * i, ball: Float32Array.from([0.05 * i, 1, 0.04, 0, 0, 0, 1]), robots: [{ side: 'left', unum, type: 0, torso: [x, 0, 0.4], poses }] };
}

const arm = (shown) => shown.robots[0].poses[7] - shown.robots[0].poses[0];

test('a browser that draws 2 pictures a second, its clock behind that of the messages', () => {
  const motion = new Motion();
  let last = -1;
  for (let picture = 1; picture < 40; ++picture) {
    const now = 500 * picture;
    for (let i = 12 * (picture - 1); i < 12 * picture; ++i) motion.take(frame(i), now);
    const shown = motion.advance(now - 450); // a picture's time is that of its start
    assert.ok(Math.abs(arm(shown)) <= 0.3001, `limbs stay at their robot: ${arm(shown)} m`);
    assert.ok(shown.robots[0].poses[0] >= last - 1e-6, 'time does not run back');
    last = shown.robots[0].poses[0];
  }
  assert.ok(last > 0.03 * 12 * 37, 'and it is not left behind');
});

test('slow pictures with messages read at once show nearly the newest frame', () => {
  const motion = new Motion();
  for (let picture = 1; picture < 10; ++picture) {
    for (let i = 12 * (picture - 1); i < 12 * picture; ++i) motion.take(frame(i), 500 * picture);
    const shown = motion.advance(500 * picture + 1);
    if (picture > 3) assert.ok(shown.robots[0].poses[0] > 0.03 * (12 * picture - 1 - 2.5), 'two frames behind at most');
  }
});

test('60 pictures a second go evenly', () => {
  const motion = new Motion();
  let next = 0, last = null;
  const steps = [];
  for (let now = 0; now < 4000; now += 1000 / 60) {
    for (; 40 * next <= now; ++next) motion.take(frame(next), 40 * next);
    const x = motion.advance(now)?.robots[0].poses[0];
    if (now > 1000) steps.push(x - last);
    last = x;
  }
  const usual = 0.03 / 40 * (1000 / 60);
  for (const step of steps) assert.ok(Math.abs(step - usual) < 0.4 * usual, `a step of ${step} m instead of ${usual}`);
});

test('messages at any times and pictures at any times never leave what was sent', () => {
  let seed = 3;
  const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647;
  for (let round = 0; round < 50; ++round) {
    const motion = new Motion();
    let now = 0, i = 0;
    for (let k = 0; k < 300; ++k) {
      now += random() < 0.1 ? 2000 * random() : 30 * random();
      if (random() < 0.6) motion.take(frame(i++), now + 20 * (random() - 0.5));
      else motion.advance(now - 100 * random());
      if (motion.shown) assert.ok(Math.abs(arm(motion.shown)) <= 0.3001);
      if (motion.shown) assert.ok(motion.shown.robots[0].poses[0] <= 0.03 * i);
    }
  }
});

test('after a pause of the stream nothing jumps', () => {
  const motion = new Motion();
  for (let i = 0; i < 20; ++i) { motion.take(frame(i), 40 * i); motion.advance(40 * i); }
  const before = motion.advance(5000).robots[0].poses[0];
  motion.take(frame(20), 5010);
  assert.ok(Math.abs(motion.advance(5010).robots[0].poses[0] - before) < 0.004);
  assert.ok(Math.abs(motion.advance(5200).robots[0].poses[0] - 0.6) < 1e-6);
});

test('what is beamed does not slide, and who comes or goes makes a new list', () => {
  const motion = new Motion();
  motion.take(frame(0), 0);
  const first = motion.advance(0).robots;
  motion.take(frame(1), 40);
  assert.equal(motion.advance(60).robots, first);
  motion.take(frame(2, { jump: 5 }), 80);
  const x = motion.advance(90).robots[0].poses[0];
  assert.ok(x < 0.07 || x > 5, `${x} m is on the way`);
  motion.take(frame(3, { unum: 2 }), 120);
  assert.notEqual(motion.advance(400).robots, first);
  assert.equal(motion.shown.robots[0].unum, 2);
});
