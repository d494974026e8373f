// The field from above on a canvas: one moment, maps.
const colours = { left: '#2f6fe8', right: '#e0452f' };
const border = 1; // [m]

function makeCanvas(canvas, field, height) {
  const width = canvas.clientWidth || 600, scale = width / (field.length + 2 * border);
  const ratio = window.devicePixelRatio || 1;
  canvas.width = width * ratio;
  canvas.height = (height ?? scale * (field.width + 2 * border)) * ratio;
  canvas.style.height = `${canvas.height / ratio}px`;
  const c = canvas.getContext('2d');
  c.setTransform(ratio * scale, 0, 0, -ratio * scale, canvas.width / 2, canvas.height / 2);
  return { c, pixel: 1 / scale };
}

function drawField(c, field, pixel, grass = '#4d8f48', line = 'rgba(255,255,255,0.8)') {
  c.fillStyle = grass;
  c.fillRect(-field.length, -field.width, 2 * field.length, 2 * field.width);
  c.strokeStyle = line;
  c.lineWidth = 1.3 * pixel;
  c.beginPath();
  for (const [x1, y1, x2, y2] of field.lines) {
    c.moveTo(x1, y1);
    c.lineTo(x2, y2);
  }
  const [x, y, radius] = field.circle ?? [0, 0, 2];
  c.moveTo(x + radius, y);
  c.arc(x, y, radius, 0, 2 * Math.PI);
  for (const side of [-1, 1]) c.rect(side * field.length / 2, -field.goalWidth / 2, side * field.goalDepth, field.goalWidth);
  c.stroke();
}

function dot(c, x, y, radius, colour) {
  c.fillStyle = colour;
  c.beginPath();
  c.arc(x, y, radius, 0, 2 * Math.PI);
  c.fill();
}

function drawMoment(canvas, game, i, decided = []) {
  const { c, pixel } = makeCanvas(canvas, game.field);
  drawField(c, game.field, pixel);
  c.strokeStyle = 'rgba(255,255,255,0.75)';
  c.lineWidth = 2 * pixel;
  c.beginPath();
  for (let k = Math.max(0, i - 20); k <= i; ++k) c[k === Math.max(0, i - 20) ? 'moveTo' : 'lineTo'](game.ball[3 * k] / 100, game.ball[3 * k + 1] / 100);
  c.stroke();
  for (const robot of game.robots) {
    const place = robotAt(robot, i);
    if (!place) continue;
    dot(c, place.x, place.y, 9 * pixel, colours[robot.side]);
    c.strokeStyle = place.up ? '#fff' : '#10171d';
    c.lineWidth = (place.up ? 1.2 : 2.5) * pixel;
    c.stroke();
    c.save();
    c.translate(place.x, place.y);
    c.scale(pixel, -pixel);
    c.fillStyle = '#fff';
    c.font = 'bold 11px system-ui, sans-serif';
    c.textAlign = 'center';
    c.textBaseline = 'middle';
    c.fillText(robot.unum, 0, 0.5);
    c.restore();
  }
  for (const one of decided) drawDecision(c, one, pixel);
  dot(c, game.ball[3 * i] / 100, game.ball[3 * i + 1] / 100, 5 * pixel, '#fff');
  c.strokeStyle = '#10171d';
  c.lineWidth = 1.2 * pixel;
  c.stroke();
}

// How often somebody was somewhere; places [[x, y], ...] in metres.
function drawHeat(canvas, game, places, side) {
  const { c, pixel } = makeCanvas(canvas, game.field), cell = 0.5;
  const columns = Math.ceil((game.field.length + 2) / cell), rows = Math.ceil((game.field.width + 2) / cell);
  let counts = new Float64Array(columns * rows);
  for (const [x, y] of places) {
    const i = Math.floor((x + game.field.length / 2 + 1) / cell), j = Math.floor((y + game.field.width / 2 + 1) / cell);
    if (i >= 0 && i < columns && j >= 0 && j < rows) ++counts[j * columns + i];
  }
  for (let pass = 0; pass < 2; ++pass) { // smoothed, so that one sees areas
    const next = new Float64Array(counts.length);
    for (let j = 0; j < rows; ++j) for (let i = 0; i < columns; ++i) {
      let sum = 0, weight = 0;
      for (const [di, dj, w] of [[0, 0, 4], [1, 0, 2], [-1, 0, 2], [0, 1, 2], [0, -1, 2], [1, 1, 1], [-1, 1, 1], [1, -1, 1], [-1, -1, 1]]) {
        const a = i + di, b = j + dj;
        if (a < 0 || a >= columns || b < 0 || b >= rows) continue;
        sum += w * counts[b * columns + a];
        weight += w;
      }
      next[j * columns + i] = sum / weight;
    }
    counts = next;
  }
  const sorted = [...counts].sort((a, b) => a - b), most = sorted[Math.floor(0.995 * (sorted.length - 1))] || 1;
  drawField(c, game.field, pixel, '#f4f7f8', '#b9c5cc');
  counts.forEach((n, k) => {
    if (!n) return;
    c.globalAlpha = Math.min(1, 0.92 * Math.sqrt(n / most));
    c.fillStyle = side ? colours[side] : '#7a4a12';
    c.fillRect((k % columns) * cell - game.field.length / 2 - 1, Math.floor(k / columns) * cell - game.field.width / 2 - 1, cell + pixel / 2, cell + pixel / 2);
  });
  c.globalAlpha = 1;
}

function arrow(c, x1, y1, x2, y2, pixel) {
  const angle = Math.atan2(y2 - y1, x2 - x1), head = 8 * pixel;
  c.beginPath();
  c.moveTo(x1, y1);
  c.lineTo(x2, y2);
  for (const turn of [2.6, -2.6]) {
    c.moveTo(x2, y2);
    c.lineTo(x2 + head * Math.cos(angle + turn), y2 + head * Math.sin(angle + turn));
  }
  c.stroke();
}

function drawEvents(canvas, game, events, kind) {
  const { c, pixel } = makeCanvas(canvas, game.field);
  drawField(c, game.field, pixel, '#f4f7f8', '#b9c5cc');
  c.lineWidth = 1.8 * pixel;
  for (const event of events.filter((e) => e.kind === kind)) {
    c.strokeStyle = colours[event.side];
    const goal = (event.side === 'left' ? 1 : -1) * game.field.length / 2;
    if (kind === 'pass') arrow(c, event.x, event.y, event.to.x, event.to.y, pixel);
    // Of a goal, the ball may have taken another way than it first went, or nobody is known to have sent it.
    const way = event.v ? (goal - event.x) / event.v.x : 0;
    if (kind === 'shot' && way > 0 && Number.isFinite(way)) arrow(c, event.x, event.y, goal, event.y + way * event.v.y, pixel);
    dot(c, event.x, event.y, 3.5 * pixel, colours[event.side]);
  }
}

function drawBallWay(canvas, game, plays) {
  const { c, pixel } = makeCanvas(canvas, game.field);
  drawField(c, game.field, pixel, '#f4f7f8', '#b9c5cc');
  c.lineWidth = 1.2 * pixel;
  for (let i = 1; i < game.times.length; ++i) {
    const a = ballAt(game, i - 1), b = ballAt(game, i);
    if (!plays[i] || Math.hypot(a.x - b.x, a.y - b.y) > 2) continue;
    c.strokeStyle = `hsl(${210 + 150 * (i / game.times.length)}, 65%, 45%)`;
    c.globalAlpha = 0.55;
    c.beginPath();
    c.moveTo(a.x, a.y);
    c.lineTo(b.x, b.y);
    c.stroke();
  }
  c.globalAlpha = 1;
}
