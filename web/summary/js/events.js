// What happened in a game, from places alone. Times are those of the recording [s], places centimetres in the file and
// metres here. A player is an index into game.robots.
const touchGain = 0.8, touchReach = 0.5, shotSpeed = 1.5, shotReach = 12, besideGoal = 0.5, shotSeconds = 2, passWay = 1.5; // [m/s, m, s]
const turned = Math.cos(Math.PI / 5), moving = 0.5, possessionReach = 1.5, fallSeconds = 0.5, touchPause = 0.4; // [s, m]

// Places of moment i, or null.
function robotAt(robot, i) {
  const x = robot.track[3 * i];
  return x === null || x === undefined ? null : { x: x / 100, y: robot.track[3 * i + 1] / 100, up: robot.track[3 * i + 2] === 1 };
}
const ballAt = (game, i) => ({ x: game.ball[3 * i] / 100, y: game.ball[3 * i + 1] / 100, z: game.ball[3 * i + 2] / 100 });
const other = (side) => (side === 'left' ? 'right' : 'left');
const distance = (a, b) => Math.hypot(a.x - b.x, a.y - b.y);

// Whether the game goes on, by moment: in play, and nobody puts the ball somewhere.
function playsAt(game) {
  let state = -1;
  return game.times.map((time) => {
    while (state + 1 < game.states.length && game.states[state + 1].t <= time) ++state;
    const mode = game.states[Math.max(state, 0)]?.mode ?? '';
    return !/^(BeforeKickOff|GameOver|Goal_(?!kick)|game_?over)/i.test(mode);
  });
}

// In which course of play each state is: a restart begins another one, so no pass goes over it.
function coursesOf(states) {
  let course = 0;
  return states.map(({ mode }, i) => {
    if (mode !== states[i - 1]?.mode && !/^(PlayOn|pass)/.test(mode)) ++course;
    return course;
  });
}

// The same of each moment.
function coursesAt(game) {
  const courses = coursesOf(game.states);
  let state = -1;
  return game.times.map((time) => {
    while (state + 1 < game.states.length && game.states[state + 1].t <= time) ++state;
    return courses[state] ?? 0;
  });
}

function goals(game) {
  const found = [];
  game.states.forEach((now, i) => {
    const before = game.states[i - 1];
    if (!before) return;
    for (const side of ['left', 'right'])
      if (now[side] > before[side]) found.push({ kind: 'goal', side, t: now.t, score: [now.left, now.right] });
  });
  return found;
}

function falls(game) {
  return game.robots.flatMap((robot, who) => {
    const found = [];
    let since = null, reported = false;
    game.times.forEach((t, i) => {
      const clock = game.clock[i], place = robotAt(robot, i);
      if (!place || place.up) {
        since = null;
        reported = false;
      } else {
        since ??= { t, clock };
        if (!reported && clock - since.clock >= fallSeconds) {
          found.push({ kind: 'fall', side: robot.side, who, t: since.t, x: place.x, y: place.y });
          reported = true;
        }
      }
    });
    return found;
  });
}

// [who, distance] of the player nearest to the ball.
function nearest(game, i) {
  const ball = ballAt(game, i);
  let best = [-1, Infinity];
  game.robots.forEach((robot, who) => {
    const place = robotAt(robot, i);
    if (!place) return;
    const d = distance(place, ball);
    if (d < best[1]) best = [who, d];
  });
  return best;
}

// The ball's velocity from moment i to the next by the game's clock [m/s]; null where it stands or the ball was put elsewhere.
function velocity(game, i) {
  const dt = game.clock[i + 1] - game.clock[i];
  if (!(dt > 0.01 && dt < 1)) return null;
  const a = ballAt(game, i), b = ballAt(game, i + 1), v = { x: (b.x - a.x) / dt, y: (b.y - a.y) / dt };
  return Math.hypot(v.x, v.y) > 15 ? null : v;
}

function touches(game, plays) {
  const found = [], courses = coursesAt(game);
  for (let i = 1; i + 1 < game.times.length; ++i) {
    if (!plays[i]) continue;
    const before = velocity(game, i - 1), after = velocity(game, i);
    if (!before || !after) continue;
    const was = Math.hypot(before.x, before.y), is = Math.hypot(after.x, after.y);
    const bends = was > moving && is > moving && before.x * after.x + before.y * after.y < turned * was * is;
    if (is - was < touchGain && !bends) continue;
    const [who, d] = nearest(game, i);
    if (who < 0 || d > touchReach) continue;
    const last = found.at(-1);
    // Another player may be nearer to the ball at the end of a kick.
    const goesOn = last && (last.who === who || last.v.x * after.x + last.v.y * after.y >= turned * last.speed * is);
    if (goesOn && game.clock[i] - last.clock < touchPause) {
      if (is > last.speed) Object.assign(last, { speed: is, v: after });
      continue;
    }
    found.push({ ...ballAt(game, i), t: game.times[i], clock: game.clock[i], who, side: game.robots[who].side, speed: is, v: after, course: courses[i] });
  }
  return found;
}

// Whether a ball that rolls so comes to the goal the side plays at, or near beside it.
function towardsGoal({ x, y, v, speed, side }, field) {
  const goal = (side === 'left' ? 1 : -1) * field.length / 2, way = (goal - x) / v.x;
  if (speed < shotSpeed || !(way > 0 && way < shotSeconds) || Math.abs(goal - x) > shotReach) return false;
  return Math.abs(y + way * v.y) < field.goalWidth / 2 + besideGoal;
}

// The shots, as src/watch/BallTouches.h says what one is: touches, and goals before which nobody is known to have touched the ball.
function shotsOf(game, found) {
  const shots = new Set(found.filter((touch, i) => {
    const next = found[i + 1];
    const dribbled = next && next.who === touch.who && next.course === touch.course && distance(touch, next) < passWay;
    return !dribbled && towardsGoal(touch, game.field);
  }));
  const courses = coursesOf(game.states);
  game.states.forEach(({ t, mode }, i) => {
    const side = { Goal_Left: 'left', Goal_Right: 'right' }[mode];
    if (!side || i === 0 || mode === game.states[i - 1].mode) return;
    const last = found.findLast((touch) => touch.t < t);
    if (last?.course !== courses[i - 1]) shots.add({ ...ballAt(game, Math.max(0, game.times.findLastIndex((time) => time <= t))), t, side });
    else if (last.side === side) shots.add(last);
  });
  return shots;
}

function passesAndShots(game, found) {
  const shots = shotsOf(game, found), events = [...shots].map((shot) => ({ ...shot, kind: 'shot' }));
  found.forEach((touch, i) => {
    const next = found[i + 1];
    if (!shots.has(touch) && next && next.who !== touch.who && distance(touch, next) >= passWay) {
      const completed = next.side === touch.side && next.course === touch.course;
      events.push({ ...touch, kind: completed ? 'pass' : 'lost pass', to: { x: next.x, y: next.y, who: next.who } });
    }
  });
  return events;
}

// Of the lost passes the page shows the number alone. src/watch/BallTouches.h counts touches, shots and passes in the same way.
// Everything of a game: events by time, and figures by side.
function analyse(game) {
  const plays = playsAt(game), found = touches(game, plays);
  const sent = passesAndShots(game, found), events = [...goals(game), ...falls(game), ...sent.filter((event) => event.kind !== 'lost pass')].sort((a, b) => a.t - b.t);
  const figures = {};
  for (const side of ['left', 'right']) {
    const of = (kind) => events.filter((event) => event.kind === kind && event.side === side).length;
    const own = found.filter((touch) => touch.side === side);
    let lost = 0;
    found.forEach((touch, i) => { if (touch.side === side && found[i + 1] && found[i + 1].side !== side) ++lost; });
    figures[side] = { goals: of('goal'), shots: of('shot'), passes: of('pass'), made: sent.filter((event) => event.side === side && event.kind !== 'shot').length, touches: own.length, lost, falls: of('fall'), possession: 0, half: 0, way: 0 };
  }
  game.times.forEach((t, i) => {
    if (!plays[i]) return;
    const ball = ballAt(game, i), [who, d] = nearest(game, i);
    if (who >= 0 && d < possessionReach) ++figures[game.robots[who].side].possession;
    ++figures[ball.x > 0 ? 'left' : 'right'].half;
    for (const robot of game.robots) {
      const a = i > 0 ? robotAt(robot, i - 1) : null, b = robotAt(robot, i);
      const step = a && b ? distance(a, b) : 0;
      if (step < 0.5) figures[robot.side].way += step;
    }
  });
  return { events, figures, plays };
}
if (typeof module !== 'undefined') module.exports = { analyse };
