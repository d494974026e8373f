// What a summary counts, from made-up games: node --test tests/e2e/web/summary.test.mjs
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import vm from 'node:vm';

const scope = { module: {} };
vm.runInNewContext(readFileSync(new URL('../../../web/summary/js/events.js', import.meta.url), 'utf8'), scope);
const analyse = (game) => JSON.parse(JSON.stringify(scope.module.exports.analyse(game)));

// Ten moments a second; at(t) gives the ball and the players [side, unum, x, y, up] in metres.
function play(seconds, at, states = []) {
  const times = Array.from({ length: Math.round(seconds * 10) + 1 }, (_, i) => i / 10);
  const first = at(0).players;
  return {
    field: { length: 30, width: 20, goalWidth: 2.1 }, times, clock: times,
    states: [{ t: 0, mode: 'PlayOn', left: 0, right: 0 }, ...states],
    ball: times.flatMap((t) => { const [x, y] = at(t).ball; return [Math.round(100 * x), Math.round(100 * y), 4]; }),
    robots: first.map(([side, unum], n) => ({ side, unum, track: times.flatMap((t) => { const [, , x, y, up = true] = at(t).players[n]; return [Math.round(100 * x), Math.round(100 * y), up ? 1 : 0]; }) })),
  };
}
const kinds = (result) => result.events.map(({ kind, side }) => `${kind} ${side}`);
// A ball that begins to roll at a time with a speed, along x.
const rolls = (t, begin, x, speed) => x + Math.max(0, t - begin) * speed;

test('a ball that a player sends to a mate is a pass', () => {
  const game = play(6, (t) => ({
    ball: [t < 3 ? rolls(t, 1, 0, 2) : rolls(t, 3, 4, 3), 3],
    players: [['left', 2, -0.2, 3], ['left', 3, 3.9, 3], ['right', 4, 9, -5]],
  }));
  const { events, figures } = analyse(game);
  assert.deepEqual(events.map(({ kind, who, to }) => [kind, who, to?.who]), [['pass', 0, 1]]);
  assert.equal(figures.left.passes, 1);
  assert.equal(figures.left.touches, 2);
  assert.equal(figures.right.touches, 0);
});

for (const file of ['passes', 'shots']) test(`touches, shots and passes are those that C++ counts: ${file}`, () => {
  const { field, seconds, states, ball, players, expected } = JSON.parse(readFileSync(new URL(`../../data/touches/${file}.json`, import.meta.url)));
  const placeAt = (way, t) => {
    const i = Math.max(1, way.findIndex(([end]) => end >= t)), [a, ax, ay] = way[i - 1], [b, bx, by] = way[i], part = (t - a) / (b - a);
    return [ax + part * (bx - ax), ay + part * (by - ay)];
  };
  const game = play(seconds, (t) => ({ ball: placeAt(ball, t), players: players.map(({ side, unum, way }) => [side, unum, ...placeAt(way, t)]) }));
  const { figures } = analyse({ ...game, field, states });
  for (const side of ['left', 'right']) {
    const { touches, shots, made, passes } = figures[side];
    assert.deepEqual({ touches, shots, made, passes }, expected[side], side);
  }
});

test('a ball that an opponent takes is lost', () => {
  const { events, figures } = analyse(play(6, (t) => ({
    ball: [t < 3 ? rolls(t, 1, 0, 2) : 4 - 3 * (t - 3), 3],
    players: [['left', 2, -0.2, 3], ['right', 3, 4.2, 3]],
  })));
  assert.deepEqual(events.map(({ kind }) => kind), []);
  assert.deepEqual([figures.left.lost, figures.right.lost], [1, 0]);
});

test('a shot goes towards the goal, fast and from near', () => {
  const shoot = (y, x, speed) => kinds(analyse(play(3, (t) => ({ ball: [rolls(t, 1, x, speed), y], players: [['left', 2, x - 0.2, y]] }))));
  assert.deepEqual(shoot(0, 8, 4), ['shot left']);
  assert.deepEqual(shoot(1.5, 8, 4), ['shot left']);
  assert.deepEqual(shoot(4, 8, 4), []);
  assert.deepEqual(shoot(0, -8, 4), []);
  assert.deepEqual(shoot(0, 13, 1.4), []);
  assert.deepEqual(shoot(0, 2.9, 7), []);
});

test('a ball that stops short of the goal is no shot', () => {
  const send = (speed) => kinds(analyse(play(3, (t) => ({ ball: [rolls(t, 1, 9, speed), 0], players: [['left', 2, 8.8, 0]] }))));
  assert.deepEqual(send(2.9), []);
  assert.deepEqual(send(3.1), ['shot left']);
});

test('who dribbles shoots once', () => {
  const push = (way) => kinds(analyse(play(5, (t) => ({
    ball: [t < 3 ? Math.min(rolls(t, 1, 12, 2), 12 + way) : rolls(t, 3, 12 + way, 4), 0],
    players: [['left', 2, t < 2 ? 11.8 : 11.8 + way, 0]],
  }))));
  assert.deepEqual(push(1.4), ['shot left']);
  assert.deepEqual(push(1.6), ['shot left', 'shot left']);
});

test('a goal is a shot of who touched the ball last', () => {
  const states = [{ t: 0, mode: 'PlayOn', left: 0, right: 0 }, { t: 3, mode: 'Goal_Left', left: 1, right: 0 }];
  const score = (side, speed) => analyse({ ...play(4, (t) => ({ ball: [Math.min(rolls(t, 1, 13, speed), 15), 0], players: [[side, 2, 12.8, 0]] })), states });
  assert.deepEqual(kinds(score('left', 1)), ['shot left', 'goal left']);
  assert.deepEqual(kinds(score('left', 3)), ['shot left', 'goal left']);
  assert.deepEqual(kinds(score('right', 3)), ['goal left']);
  const nobody = score('left', 0.5).events.filter(({ kind }) => kind === 'shot');
  assert.deepEqual(nobody.map(({ side, who, t, x }) => [side, who, t, x]), [['left', undefined, 3, 14]]);
});

test('the right team shoots at the other goal', () => {
  assert.deepEqual(kinds(analyse(play(3, (t) => ({ ball: [-8 - 4 * Math.max(0, t - 1), 0], players: [['right', 2, -7.8, 0]] })))), ['shot right']);
});

test('a fall counts once, and a stumble not', () => {
  const lies = (t) => (t > 1 && t < 3) || (t > 4 && t < 4.25);
  const { events, figures } = analyse(play(6, (t) => ({ ball: [0, 0], players: [['right', 5, 5, 5, !lies(t)]] })));
  assert.deepEqual(events.map(({ kind, t }) => [kind, t]), [['fall', 1.1]]);
  assert.equal(figures.right.falls, 1);
});

test('goals are changes of the score', () => {
  const game = play(6, () => ({ ball: [0, 0], players: [['left', 1, -14, 0]] }), [
    { t: 2, mode: 'Goal_Left', left: 1, right: 0 }, { t: 4, mode: 'PlayOn', left: 1, right: 0 }, { t: 5, mode: 'Goal_Right', left: 1, right: 1 }]);
  assert.deepEqual(analyse(game).events.filter(({ kind }) => kind === 'goal').map(({ kind, side, score }) => [kind, side, score]), [['goal', 'left', [1, 0]], ['goal', 'right', [1, 1]]]);
});

test('what is done while the game rests does not count, and a ball that is put somewhere was not kicked', () => {
  const before = play(4, (t) => ({ ball: [rolls(t, 1, 8, 4), 0], players: [['left', 2, 7.8, 0]] }), []);
  before.states[0].mode = 'BeforeKickOff';
  assert.deepEqual(analyse(before).events, []);
  assert.deepEqual(analyse(play(4, (t) => ({ ball: [t < 2 ? 0 : 8, 0], players: [['left', 2, 0.1, 0]] }))).events, []);
});

test('possession and ways', () => {
  const { figures } = analyse(play(10, (t) => ({ ball: [1, 0], players: [['left', 2, t < 5 ? 1.2 : 9 - 0, 0], ['right', 3, t < 5 ? 9 : 1.5, t / 10]] })));
  assert.equal(figures.left.possession, 50);
  assert.equal(figures.right.possession, 51);
  assert.ok(Math.abs(figures.right.way - 1) < 0.05);
});
