// The robot as a figure whose joints have the colour of their gap; drawn from the robot's own file.
report.figure = (figure, rows, most) => {
  const { el, number, percent } = report;
  if (!figure?.joints?.length) return null;
  const turn = 0.42, tilt = 0.12; // seen from the front, a little from the side and from above
  const flat = ([x, y, z]) => [y * Math.cos(turn) + x * Math.sin(turn), -z + tilt * (x * Math.cos(turn) - y * Math.sin(turn))];
  const points = figure.joints.map((j) => flat(j.p)), ends = figure.joints.map((j) => flat(j.end));
  const all = [...points, ...ends, flat(figure.base ?? [0, 0, 0])];
  const [left, right] = [Math.min(...all.map((p) => p[0])), Math.max(...all.map((p) => p[0]))];
  const [top, bottom] = [Math.min(...all.map((p) => p[1])), Math.max(...all.map((p) => p[1]))];
  const size = 300 / Math.max(right - left, (bottom - top) * 0.75, 1e-6);
  const at = ([x, y]) => [30 + (x - left) * size, 30 + (y - top) * size];
  const svg = el('svg', { viewBox: `0 0 ${60 + (right - left) * size} ${60 + (bottom - top) * size}`, role: 'img', 'aria-label': 'The robot; joints coloured by their gap' });
  figure.joints.forEach((joint, i) => {
    const from = at(joint.parent >= 0 ? points[joint.parent] : flat(figure.base ?? [0, 0, 0])), to = at(points[i]), end = at(ends[i]);
    svg.append(el('line', { x1: from[0], y1: from[1], x2: to[0], y2: to[1] }));
    if (joint.leaf) svg.append(el('line', { x1: to[0], y1: to[1], x2: end[0], y2: end[1] }));
  });
  const mark = (name, signals, [x, y], base) => {
    const found = rows.filter((r) => signals(r.signal));
    const worst = Math.max(1, ...found.map((r) => r.worst)), share = found.reduce((a, r) => a + r.share, 0);
    const radius = base + 9 * Math.sqrt(Math.min(1, share));
    const light = () => {
      for (const lit of document.querySelectorAll('#map .lit')) lit.classList.remove('lit');
      for (const row of found) document.querySelector(`#map .name[data-signal="${CSS.escape(row.signal)}"]`)?.classList.add('lit');
    };
    const circle = el('circle', { cx: x, cy: y, r: radius, fill: report.heat(worst, most).fill, class: 'part', onclick: light, onmouseenter: light },
      el('title', {}, found.length ? `${name}: up to ${number(worst, 2)} times the noise, ${percent(share)} of the gap` : `${name}: not measured`));
    return { circle, share, name, x, y, radius };
  };
  const marks = figure.joints.map((j, i) => mark(j.name, (s) => s.slice(s.indexOf('.') + 1) === j.name, at(points[i]), 4));
  if (figure.imu) marks.push(mark('inertial sensor', (s) => s.startsWith('gyro.') || s.startsWith('acc.'), at(flat(figure.imu)), 5));
  for (const foot of figure.feet ?? []) marks.push(mark(`force sensors ${foot.name}`, (s) => s.startsWith(`fsr.${foot.name}.`), at(flat(foot.p)), 4));
  marks.sort((a, b) => a.share - b.share);
  svg.append(...marks.map((m) => m.circle));
  const strongest = marks.at(-1);
  if (strongest.share > 0.05) {
    const width = 60 + (right - left) * size, onRight = strongest.x < width * 0.6;
    svg.append(el('text', { x: strongest.x + (onRight ? 1 : -1) * (strongest.radius + 5), y: strongest.y + 4, 'text-anchor': onRight ? 'start' : 'end' }, strongest.name));
  }
  return el('div', { class: 'figure' }, svg, el('p', { class: 'small dim' }, 'Colour: gap in units of noise. Size: share of the whole gap.'));
};
