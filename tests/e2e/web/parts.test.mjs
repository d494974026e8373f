// Parts of the page that need no browser: node --test tests/e2e/web/parts.test.mjs
import assert from 'node:assert/strict';
import test from 'node:test';
import { bonesOf } from '../../../web/js/bones.js';
import { exchanged } from '../../../web/js/teams.js';

test('teams exchange colours only if a name says the opposite', () => {
  assert.equal(exchanged('Plumbline', 'Line'), false);
  assert.equal(exchanged('Red', 'Blue'), true);
  assert.equal(exchanged('Red', 'Other'), true);
  assert.equal(exchanged('Other', 'team_blue'), true);
  assert.equal(exchanged('Blue', 'Red'), false);
  assert.equal(exchanged('Red', 'Red2'), false); // the right one is red already
  assert.equal(exchanged('Redmond', 'Bluebird'), false); // no colours
  assert.equal(exchanged('Blue', 'Blue2'), false);
});

test('a bone reaches from inside a box to a joint outside it', () => {
  const [shoulder, elbow] = bonesOf({ shape: 'box', size: [0.08, 0.07, 0.06], joints: [[-0.02, -0.01, 0], [0.10664, -0.01, 0.009]] });
  assert.equal(shoulder.length, 0); // inside already: a ball
  assert.ok(Math.abs(elbow.length - (0.10664 - 0.0336)) < 1e-9);
  assert.deepEqual(elbow.direction, [1, 0, 0]);
  assert.ok(Math.abs(elbow.middle[0] + elbow.length / 2 - 0.10664) < 1e-9);
});

test('other shapes, and recordings that tell no joints, have no bones', () => {
  assert.deepEqual(bonesOf({ shape: 'sphere', size: [0.01], joints: [[0, 0, 0]] }), []);
  assert.deepEqual(bonesOf({ shape: 'box', size: [1, 1, 1] }), []);
});
