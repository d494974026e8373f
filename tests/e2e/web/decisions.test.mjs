// Which decision a summary shows at a moment: node --test tests/e2e/web/decisions.test.mjs
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import vm from 'node:vm';

const scope = { module: {} };
vm.runInNewContext(readFileSync(new URL('../../../web/summary/js/decisions.js', import.meta.url), 'utf8'), scope);
const at = (players, clock) => JSON.parse(JSON.stringify(scope.module.exports.decisionsAt(players, clock)));

const kick = (value) => [['kickLong', 5, 1, value, 0.25], ['dribble', 1, 0, 0.1, 0]];
const players = [
  { side: 'left', unum: 7, lines: [[10, 0, 0, kick(0.3)], [10.4, 0.1, 0, kick(0.4)], [20, 3, 0, kick(0.5)]] },
  { side: 'right', unum: 2, lines: [[11, 0, 1, kick(0.2)]] },
];

test('the last decision before a moment is shown, for a second and a half', () => {
  assert.deepEqual(at(players, 9.9), []);
  assert.equal(at(players, 10)[0].actions[0].value, 0.3);
  assert.equal(at(players, 10.39)[0].actions[0].value, 0.3);
  assert.equal(at(players, 10.4)[0].actions[0].value, 0.4);
  assert.equal(at(players, 11.9)[0].actions[0].value, 0.4);
  assert.deepEqual(at(players, 15), []);
  assert.equal(at(players, 21)[0].x, 3);
});

test('players of both teams decide at once, each with what it decided against', () => {
  const both = at(players, 11.2);
  assert.deepEqual(both.map(({ side, unum }) => [side, unum]), [['left', 7], ['right', 2]]);
  assert.deepEqual(both[1].actions, [{ action: 'kickLong', x: 5, y: 1, value: 0.2, goal: 0.25 }, { action: 'dribble', x: 1, y: 0, value: 0.1, goal: 0 }]);
});

test('without files, or in an empty one, nobody decides', () => {
  assert.deepEqual(at(null, 10), []);
  assert.deepEqual(at([{ side: 'left', unum: 1, lines: [] }], 10), []);
});
