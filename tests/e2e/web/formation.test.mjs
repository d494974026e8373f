// The model of the formation that is edited, without a browser: node --test tests/e2e/web/formation.test.mjs
import assert from 'node:assert/strict';
import test from 'node:test';
import { FormationModel } from '../../../web/js/agent/formation.js';

const file = () => ({
  revision: 'a1', ballX: [-10, 10], ballY: [0, 8],
  places: [
    { name: 'leftBack', x: [[-12, -4], [-12, -4]], y: [[2, 2], [6, 6]] },
    { name: 'rightBack', x: [[-12, -4], [-13, -5]], y: [[-2, -2], [-1, -1]] },
    { name: 'cover', x: [[-5, 0], [-5, 0]], y: [[0, 0], [2, 2]] }],
});

test('places are where FormationTable has them', () => {
  const model = new FormationModel(file());
  assert.deepEqual(model.at(0, [-10, 0]), [-12, 2]);
  assert.deepEqual(model.at(0, [0, 4]), [-8, 4]);
  assert.deepEqual(model.at(0, [10, -8]), [-5, 1]);
  assert.deepEqual(model.at(0, [50, 90]), [-4, 6]);
});

test('a place is moved for one ball of the table alone', () => {
  const model = new FormationModel(file());
  assert.equal(model.move(0, [10, 8], [-3, 5]), true);
  assert.deepEqual(model.at(0, [10, 8]), [-3, 5]);
  assert.deepEqual(model.places[0].x, [[-12, -4], [-12, -3]]);
  assert.deepEqual(model.at(1, [10, -8]), [-3, -5]);
});

test('for a ball on the right the mirror image moves', () => {
  const model = new FormationModel(file());
  model.move(0, [10, -8], [-6, 2]);
  assert.deepEqual(model.at(0, [10, -8]), [-6, 2]);
  assert.deepEqual([model.places[1].x[1][1], model.places[1].y[1][1]], [-6, -2]);
});

test('for a ball in the middle left and right stay mirror images, and the middle stays there', () => {
  const model = new FormationModel(file());
  model.move(0, [-10, 0], [-11, 3]);
  assert.deepEqual(model.at(1, [-10, 0]), [-11, -3]);
  model.move(2, [-10, 0], [-6, 1]);
  assert.deepEqual(model.at(2, [-10, 0]), [-6, 0]);
});

test('between balls the nearest ones change so that the place is where it was put', () => {
  const model = new FormationModel(file());
  model.move(0, [5, 6], [-7, 7]);
  const [x, y] = model.at(0, [5, 6]);
  assert.ok(Math.abs(x + 7) < 0.05 && Math.abs(y - 7) < 0.05, `${x} ${y}`);
});

test('a drag is one change, undone and done again', () => {
  const model = new FormationModel(file());
  for (const x of [-11, -10, -9]) model.move(0, [-10, 8], [x, 6], 'drag');
  assert.equal(model.changed, true);
  model.undo();
  assert.equal(model.changed, false);
  model.redo();
  assert.equal(model.places[0].x[1][0], -9);
});

test('the nearest ball of the table is taken within reach', () => {
  const model = new FormationModel(file());
  assert.deepEqual(model.nearestBall([9.6, -7.7], 0.6), [10, -8]);
  assert.equal(model.nearestBall([9, -7], 0.6), null);
});

test('the text is what the debug protocol reads', () => {
  const model = new FormationModel({ ...file(), places: [file().places[2]] });
  assert.equal(model.fileText('a "b".yaml'),
    '{"a \\"b\\".yaml" "a1" "" {-10 10} {0 8} {{"cover" {{-5.00 0.00} {-5.00 0.00}} {{0.00 0.00} {2.00 2.00}}}}}');
});
