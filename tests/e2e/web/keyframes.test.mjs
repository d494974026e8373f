// The model of a motion that is edited, without a browser: node --test tests/e2e/web/keyframes.test.mjs
import assert from 'node:assert/strict';
import test from 'node:test';
import { Drafts } from '../../../web/js/agent/drafts.js';
import { KeyframeMotion } from '../../../web/js/agent/keyframes.js';

const joint = (name, degrees) => ({ joint: name, degrees });
const file = (restStays = true) => ({
  revision: 'a1', restStays, keyframes: [
    { from: 0, time: 0.5, settle: 0, joints: [joint('LShoulderPitch', -80)] },
    { from: 1, time: 0.25, settle: 0.5, joints: [joint('LElbowRoll', -60)] }],
});

test('a joint that a keyframe leaves out stays where it was', () => {
  const motion = new KeyframeMotion('wave', file());
  assert.deepEqual(motion.posture(1, { LShoulderPitch: 90, LElbowRoll: 0 }), { LShoulderPitch: -80, LElbowRoll: -60 });
  assert.deepEqual(motion.times(), [0.5, 0.75]);
  assert.deepEqual(motion.postureAt(0.25, { LShoulderPitch: 90, LElbowRoll: 0 }), { LShoulderPitch: 5, LElbowRoll: 0 });
  assert.deepEqual(motion.postureAt(9, { LShoulderPitch: 90, LElbowRoll: 0 }), { LShoulderPitch: -80, LElbowRoll: -60 });
});

test('changes are undone and done again; a slider that moves is one change', () => {
  const motion = new KeyframeMotion('wave', file());
  for (const degrees of [-70, -60, -50]) motion.setJoint(0, 'LShoulderPitch', degrees, 'slide');
  assert.equal(motion.changed, true);
  motion.undo();
  assert.equal(motion.changed, false);
  motion.redo();
  assert.equal(motion.keyframes[0].joints.LShoulderPitch, -50);
  assert.equal(motion.setJoint(0, 'LShoulderPitch', -50), false);
});

test('a new joint is in all keyframes where none may be left out', () => {
  const motion = new KeyframeMotion('kick', { ...file(false) });
  motion.setJoint(1, 'HeadYaw', 5);
  assert.deepEqual(motion.keyframes.map((k) => k.joints.HeadYaw), [5, 5]);
  motion.setJoint(1, 'HeadYaw', 6);
  assert.deepEqual(motion.keyframes.map((k) => k.joints.HeadYaw), [5, 6]);
});

test('keyframes are added, moved and removed, one stays', () => {
  const motion = new KeyframeMotion('wave', file());
  motion.insert(0);
  assert.deepEqual(motion.keyframes.map((k) => k.from), [0, -1, 1]);
  motion.move(2, -1);
  assert.deepEqual(motion.keyframes.map((k) => k.from), [0, 1, -1]);
  motion.remove(2);
  motion.remove(1);
  assert.equal(motion.remove(0), false);
});

test('joints that are asked for too much are named', () => {
  const motion = new KeyframeMotion('wave', file());
  assert.deepEqual(motion.tooFast(1, [{ joint: 'LElbowRoll', speed: 200 }, { joint: 'HeadYaw', speed: 1 }], { LElbowRoll: 0 }),
    [{ joint: 'LElbowRoll', needs: 240, speed: 200 }]);
});

test('the text is what the debug protocol reads', () => {
  assert.equal(new KeyframeMotion('wave', file()).fileText('a "b".yaml'),
    '{"a \\"b\\".yaml" "a1" "" true {{0 0.500 0.000 {{"LShoulderPitch" -80.000}}} {1 0.250 0.500 {{"LElbowRoll" -60.000}}}}}');
});

test('drafts are kept by motion', () => {
  const kept = new Map();
  const drafts = new Drafts({ getItem: (k) => kept.get(k) ?? null, setItem: (k, v) => kept.set(k, v), removeItem: (k) => kept.delete(k) });
  assert.equal(drafts.has('wave'), false);
  drafts.put(new KeyframeMotion('wave', file()));
  assert.equal(drafts.get('wave').revision, 'a1');
  drafts.drop('wave');
  assert.equal(drafts.get('wave'), null);
});
