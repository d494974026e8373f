// The result, the score over time, figures side by side, the list of events.
const clockText = (seconds) => `${Math.floor(seconds / 60)}:${String(Math.floor(seconds % 60)).padStart(2, '0')}`;
const element = (tag, text, className) => Object.assign(document.createElement(tag), { textContent: text ?? '', className: className ?? '' });

function teamNames(game) {
  const names = game.states.map((s) => s.names).reverse().find((n) => n[0] || n[1]) ?? ['', ''];
  return { left: names[0] || 'left', right: names[1] || 'right' };
}

function scoreSteps(game, events) {
  const end = game.times.at(-1), begin = game.times[0], width = 1000, height = 60;
  const goals = events.filter(({ kind }) => kind === 'goal');
  const first = game.states[0] ?? { left: 0, right: 0 };
  const most = Math.max(1, ...game.states.map(({ left, right }) => Math.max(left, right)));
  const x = (t) => (width * (t - begin)) / Math.max(end - begin, 1e-6), y = (n) => height - 6 - ((height - 14) * n) / most;
  const path = (side, shift) => {
    let d = `M0 ${y(first[side]) + shift}`, now = first[side];
    for (const goal of goals.filter((g) => g.side === side)) d += `H${x(goal.t)}V${y(++now) + shift}`;
    return `${d}H${width}`;
  };
  const svg = `<svg viewBox="0 -6 ${width} 82" preserveAspectRatio="none" role="img" aria-label="Score over time">
    <path d="M0 ${height + 2}H${width}" stroke="#d9e0e5"/>
    <path d="${path('left', -1.2)}" fill="none" stroke="var(--left)" stroke-width="2.5" vector-effect="non-scaling-stroke"/>
    <path d="${path('right', 1.2)}" fill="none" stroke="var(--right)" stroke-width="2.5" vector-effect="non-scaling-stroke"/></svg>`;
  return svg;
}

function showResult(game, { events }, names) {
  const last = game.states.at(-1) ?? { left: 0, right: 0 }, place = document.getElementById('result');
  place.append(element('div', names.left, 'team left'), element('div', `${last.left} : ${last.right}`, 'score'), element('div', names.right, 'team right'));
  place.insertAdjacentHTML('beforeend', scoreSteps(game, events));
  const goals = events.filter(({ kind }) => kind === 'goal').map((goal) => `${clockText(clockOf(game, goal.t))} ${names[goal.side]} (${goal.score.join(':')})`);
  place.append(element('div', goals.length ? `Goals: ${goals.join(', ')}` : 'No goal.', 'goals'));
}

function indexAt(game, t) {
  let low = 0, high = game.times.length - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (game.times[middle] <= t) low = middle;
    else high = middle - 1;
  }
  return low;
}
const clockOf = (game, t) => game.clock[indexAt(game, t)] ?? 0;

function showFigures(game, { figures }, names) {
  const table = document.querySelector('#figures table'), { left, right } = figures;
  const share = (key) => { const sum = left[key] + right[key]; return [left, right].map((f) => (sum ? Math.round((100 * f[key]) / sum) : 0)); };
  const rows = [['goals', left.goals, right.goals], ['shots', left.shots, right.shots], ['passes made', left.made, right.made],
    ['passes completed', left.passes, right.passes],
    ['touches', left.touches, right.touches], ['balls lost', left.lost, right.lost], ['falls', left.falls, right.falls],
    ['possession, %', ...share('possession')], ['ball in the other half, %', ...share('half')],
    ['way of all, m', Math.round(left.way), Math.round(right.way)]];
  const head = element('tr');
  head.append(element('th', names.left), element('th'), element('th', names.right));
  table.append(head, ...rows.map(([what, a, b]) => {
    const row = element('tr'), middle = element('td', what, 'what'), bars = element('div', '', 'bars');
    const sum = a + b || 1;
    bars.append(...[a, b].map((n) => Object.assign(element('i'), { style: `flex: ${n / sum}` })));
    middle.append(bars);
    row.append(element('td', a), middle, element('td', b));
    return row;
  }));
}

function describe(event, game, names) {
  const who = event.who === undefined ? '' : ` ${game.robots[event.who].unum}`;
  if (event.kind === 'goal') return `Goal for ${names[event.side]}, ${event.score.join(':')}`;
  if (event.kind === 'shot') return `${names[event.side]}${who} shoots from ${Math.abs(Math.hypot((event.side === 'left' ? 1 : -1) * game.field.length / 2 - event.x, event.y)).toFixed(1)} m`;
  if (event.kind === 'pass') return `${names[event.side]}${who} passes to ${game.robots[event.to.who].unum}, ${Math.hypot(event.to.x - event.x, event.to.y - event.y).toFixed(1)} m`;
  return `${names[event.side]}${who} falls`;
}
