// Puts the summary together: one moment on the field, a time line with all events, maps.
(() => {
  const { game, replay, decisions } = JSON.parse(document.getElementById('game').textContent);
  const result = analyse(game), names = teamNames(game), $ = (id) => document.getElementById(id);
  const begin = game.times[0], end = game.times.at(-1), share = (t) => `${(100 * (t - begin)) / Math.max(end - begin, 1e-6)}%`;
  const kinds = { goal: 'goals', shot: 'shots', pass: 'passes', fall: 'falls' }, shown = new Set(['goal', 'shot', 'pass']);
  const before = 3; // an event is looked at from so long before it [s]
  let time = begin, playing = false, last = 0;

  document.title = `${names.left} ${game.states.at(-1)?.left ?? 0}:${game.states.at(-1)?.right ?? 0} ${names.right}`;
  $('about').textContent = `${game.recording}, ${clockText(end - begin)} recorded, ${game.robots.length} players`;
  showResult(game, result, names);
  showFigures(game, result, names);
  $('decisions').hidden = $('howDecisions').hidden = !decisions;

  function show() {
    const i = indexAt(game, time);
    const decided = decisionsAt(decisions, game.clock[i]);
    drawMoment($('field'), game, i, decided);
    showDecisions($('decisions'), decided, names);
    $('clock').textContent = `${clockText(game.clock[i])} of the game; ${clockText(time)} of the recording`;
    $('in3d').href = `${replay}#t=${Math.max(0, time).toFixed(1)}`;
    now.style.left = share(time);
    $('line').setAttribute('aria-valuenow', time.toFixed(1));
  }
  function goTo(t) {
    time = Math.max(begin, Math.min(end, t));
    show();
  }

  // The line: when the game rests, events in rows by kind, where one is.
  const now = element('i', '', 'now'), line = $('line');
  function fillLine() {
    const rests = [];
    result.plays.forEach((plays, i) => {
      if (plays) return;
      if (rests.at(-1)?.end === i - 1) rests.at(-1).end = i;
      else rests.push({ begin: i, end: i });
    });
    line.replaceChildren(...rests.map((rest) => Object.assign(element('i', '', 'rest'), { style: `left: ${share(game.times[rest.begin])}; width: calc(${share(game.times[rest.end])} - ${share(game.times[rest.begin])})` })),
      ...result.events.filter(({ kind }) => shown.has(kind)).map((event) => {
        const mark = element('i', '', `event ${event.kind}`);
        mark.title = describe(event, game, names);
        const row = { goal: 0, shot: 3, pass: 17, fall: 31 }[event.kind] + (event.side === 'right' && event.kind !== 'goal' ? 3 : 0);
        mark.style = `left: ${share(event.t)}; top: ${row}px; background: ${colours[event.side]}`;
        return mark;
      }), now);
  }
  $('kinds').append(...Object.entries(kinds).map(([kind, text]) => {
    const label = element('label'), box = Object.assign(document.createElement('input'), { type: 'checkbox', checked: shown.has(kind) });
    box.onchange = () => {
      if (box.checked) shown.add(kind);
      else shown.delete(kind);
      fillLine();
      fillList();
    };
    label.append(box, `${text} (${result.events.filter((e) => e.kind === kind).length})`);
    return label;
  }));
  function fillList() {
    document.querySelector('#list ol').replaceChildren(...result.events.filter(({ kind }) => shown.has(kind)).map((event) => {
      const row = element('li', '', event.kind), mark = element('i');
      mark.style.background = colours[event.side];
      row.tabIndex = 0;
      row.append(element('b', clockText(clockOf(game, event.t))), mark, describe(event, game, names));
      row.onclick = () => goTo(event.t - (event.kind === 'goal' ? before : 1));
      row.onkeydown = ({ key }) => { if (key === 'Enter') row.click(); };
      return row;
    }));
  }
  const point = (event) => goTo(begin + ((event.clientX - line.getBoundingClientRect().left) / line.clientWidth) * (end - begin));
  line.onpointerdown = (event) => {
    line.setPointerCapture(event.pointerId);
    point(event);
  };
  line.onpointermove = (event) => { if (event.buttons) point(event); };
  line.onkeydown = ({ key }) => { if (key === 'ArrowLeft' || key === 'ArrowRight') goTo(time + (key === 'ArrowLeft' ? -5 : 5)); };
  $('play').onclick = () => {
    playing = !playing;
    $('play').textContent = playing ? '❚❚' : '▶';
    if (playing && time >= end) time = begin;
    last = performance.now();
    if (playing) requestAnimationFrame(tick);
  };
  function tick(at) {
    if (!playing) return;
    goTo(time + Math.min(0.3, Math.max(0, (at - last) / 1000)) * Number($('rate').value));
    last = at;
    if (time >= end) $('play').click();
    else requestAnimationFrame(tick);
  }
  $('field').onclick = () => $('play').click();

  // Maps.
  function map(place, title, draw) {
    const figure = element('figure'), canvas = document.createElement('canvas');
    figure.append(canvas, element('figcaption', title));
    document.querySelector(`#${place} .maps`).append(figure);
    maps.push(() => draw(canvas));
  }
  const maps = [];
  const placesOf = (side) => game.robots.filter((r) => r.side === side).flatMap((robot) => game.times.flatMap((_, i) => { const p = robotAt(robot, i); return p && result.plays[i] ? [[p.x, p.y]] : []; }));
  for (const side of ['left', 'right']) {
    const places = placesOf(side);
    map('heat', `${names[side]}; it plays to the ${side === 'left' ? 'right' : 'left'}`, (canvas) => drawHeat(canvas, game, places, side));
  }
  map('ways', 'the ball, from blue at the beginning to red at the end', (canvas) => drawBallWay(canvas, game, result.plays));
  map('ways', 'shots', (canvas) => drawEvents(canvas, game, result.events, 'shot'));
  map('ways', 'passes', (canvas) => drawEvents(canvas, game, result.events, 'pass'));
  const draw = () => {
    maps.forEach((run) => run());
    show();
  };
  addEventListener('resize', draw);
  fillLine();
  fillList();
  draw();
  goTo(result.events.find(({ kind }) => kind === 'goal')?.t - 1 || begin);
  window.plumbline = { game, result, decisions, goTo, time: () => time };
})();
