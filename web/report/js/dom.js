// What every part of the page uses: elements, numbers in words, colours.
const report = {};

/** An element with attributes and children; text is always text, never markup. */
report.el = (name, attributes = {}, ...children) => {
  const svg = ['svg', 'line', 'circle', 'path', 'rect', 'text', 'g', 'title'].includes(name);
  const element = svg ? document.createElementNS('http://www.w3.org/2000/svg', name) : document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key === 'style') Object.assign(element.style, value);
    else if (key.startsWith('on')) element.addEventListener(key.slice(2), value);
    else if (value !== undefined && value !== null && value !== false) element.setAttribute(key, value);
  }
  element.append(...children.flat().filter((c) => c !== null && c !== undefined && c !== '').map((c) => (c instanceof Node ? c : String(c))));
  return element;
};

report.isNumber = (x) => typeof x === 'number' && Number.isFinite(x);
/** Three significant digits, without an exponent where it can be helped. */
report.number = (x, digits = 3) => {
  if (!report.isNumber(x)) return '-';
  if (x === 0) return '0';
  const size = Math.abs(x);
  if (size >= 1e6 || size < 1e-5) return x.toExponential(digits - 1);
  return String(Number(x.toPrecision(digits))).replace('-', '\u2212');
};
report.percent = (share) => {
  if (!report.isNumber(share)) return '-';
  const p = 100 * share;
  return `${p > 99 && p < 100 ? '>\u202f99' : p > 0 && p < 1 ? '<\u202f1' : Math.round(p)}\u202f%`;
};
/** Units as people write them. */
report.unit = (unit) => ({ 1: '', 'N m s/rad': 'N\u202fm\u202fs/rad', 'N m': 'N\u202fm', 'm/s^2': 'm/s\u00b2', 'rad/s^2': 'rad/s\u00b2', 'kg m^2': 'kg\u202fm\u00b2' })[unit] ?? unit ?? '';
report.withUnit = (x, unit) => [report.number(x), report.unit(unit)].filter(Boolean).join('\u202f');
report.unitOfSignal = (signal) => ({ pos: 'rad', vel: 'rad/s', gyro: 'rad/s', acc: 'm/s^2', fsr: 'N', torque: 'N m', current: 'A' })[signal.split('.')[0]] ?? '';

/** Gap in units of noise, from 1 (nothing) to `most`, as a colour: pale to deep, readable with any eyes. */
report.heat = (ratio, most) => {
  const stops = [[233, 238, 243], [253, 219, 150], [247, 148, 71], [205, 55, 60], [104, 12, 62]];
  const share = Math.min(1, Math.max(0, Math.log(Math.max(ratio, 1)) / Math.log(Math.max(most, 3))));
  const place = share * (stops.length - 1), i = Math.min(stops.length - 2, Math.floor(place));
  const rgb = stops[i].map((c, k) => Math.round(c + (place - i) * (stops[i + 1][k] - c)));
  return { fill: `rgb(${rgb})`, ink: share > 0.55 ? '#fff' : '#1b232b' };
};
report.colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();

/** The first rows of a long list, and a button for the others. */
report.folded = (rows, count, container, what) => {
  container.append(...rows.slice(0, count).flat());
  if (rows.length <= count) return null;
  const button = report.el('button', { class: 'more' }, `Show all ${rows.length} ${what}`);
  button.addEventListener('click', () => {
    container.append(...rows.slice(count).flat());
    button.remove();
  });
  return button;
};
