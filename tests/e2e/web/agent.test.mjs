// Parts of the agent's page that need no browser: node --test tests/e2e/web/agent.test.mjs
import assert from 'node:assert/strict';
import test from 'node:test';
import { fieldOf, partName, placeOf, reachOf, shortName, shown, valueText } from '../../../web/js/agent/paths.js';

test('names of values and parts', () => {
  assert.equal(shortName('representation:BallPos.relative.x'), 'BallPos.relative.x');
  assert.equal(shortName('module:BallLocator:onField'), 'BallLocator:onField');
  assert.equal(partName('representation:A', { x: 1 }, 'x'), 'representation:A.x');
  assert.equal(partName('representation:A.list', [1], '0'), 'representation:A.list[0]');
});

test('what is typed becomes what the protocol reads', () => {
  assert.equal(valueText(' 0.5 '), '0.5');
  assert.equal(valueText('walk'), 'walk');
  assert.equal(valueText('{1 2 {3 4}}'), '{1 2 {3 4}}');
  assert.equal(valueText('two words'), '"two words"');
  assert.equal(valueText('a "b" \\c'), '"a \\"b\\" \\\\c"');
  assert.equal(valueText(''), '""');
});

test('places are found in points, poses and transforms', () => {
  assert.deepEqual(placeOf({ x: 1, y: 2 }), [1, 2, 0]);
  assert.deepEqual(placeOf({ x: 1, y: 2, z: 3 }), [1, 2, 3]);
  assert.deepEqual(placeOf({ position: { x: 1, y: 2 }, heading: 0.5 }), [1, 2, 0]);
  assert.deepEqual(placeOf({ rotation: [], translation: { x: 1, y: 2, z: 3 } }), [1, 2, 3]);
  for (const none of [null, 1, 'x', [1, 2], { x: 1 }, { x: 'a', y: 2 }]) assert.equal(placeOf(none), null);
});

test('numbers as one reads them', () => {
  assert.equal(shown(3), '3');
  assert.equal(shown(0.123456), '0.1235');
  assert.equal(shown(123.456), '123.46');
  assert.equal(shown(null), 'not finite');
  assert.equal(shown(true), 'true');
});

test('a slider reaches over the range, or over what is usual where the range is wide', () => {
  assert.deepEqual(reachOf({ min: 0, max: 1.5, default: '0.9' }), [0, 1.5]);
  assert.deepEqual(reachOf({ min: 0, max: 10000, default: '10' }), [0, 40]);
  assert.deepEqual(reachOf({ min: null, max: null, default: '2' }), [-8, 8]);
  assert.deepEqual(reachOf({ min: null, max: 1, default: '0' }), [-4, 1]);
});

test('the lines of a field', () => {
  const field = fieldOf({ length: 30, width: 20, goalWidth: 2.1, goalDepth: 0.6, goalHeight: 0.8, goalBarDiameter: 0.04, penaltyDepth: 1.8, penaltyWidth: 6, centreCircleRadius: 2, ballRadius: 0.042 });
  assert.equal(field.lines.length, 11);
  assert.deepEqual(field.circle, [0, 0, 2]);
  assert.ok(field.lines.every((line) => Math.abs(line[0]) <= 15 && Math.abs(line[1]) <= 10));
});
