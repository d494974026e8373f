// Names of values and their parts, as the debug protocol writes them: representation:JointData.angles[3].

// "representation:BallPos.relative.x" -> "BallPos.relative.x": what is left where the kind is plain.
export function shortName(name) {
  return name.replace(/^(representation|config|timing|module|draw):/, '');
}

// Of [key, value] below a name.
export function partName(name, value, key) {
  return Array.isArray(value) ? `${name}[${key}]` : `${name}.${key}`;
}

// What `set` wants behind the name: numbers, words, groups and texts in quotes stay as they were typed, all else is a text.
export function valueText(typed) {
  const text = typed.trim();
  if (text === '') return '""';
  if (/^[{"']/.test(text) || /^[^\s{}[\]"']+$/.test(text)) return text;
  return `"${text.replace(/[\\"]/g, (c) => `\\${c}`)}"`;
}

// A value as one reads it.
export function shown(value) {
  if (typeof value !== 'number') return value === null ? 'not finite' : String(value);
  return Number.isInteger(value) ? String(value) : value.toFixed(Math.abs(value) < 10 ? 4 : 2);
}

// [x, y, z] if the value is a place; null if not. A pose of this project has its place in "position".
export function placeOf(value) {
  if (!value || typeof value !== 'object') return null;
  const place = value.translation ?? value.position ?? value;
  if (typeof place.x !== 'number' || typeof place.y !== 'number') return null;
  return [place.x, place.y, typeof place.z === 'number' ? place.z : 0];
}

export const headingOf = (value) => (typeof value?.heading === 'number' ? value.heading : null);

// The lines of a field of these sizes, as the match page's field takes them.
export function fieldOf(d) {
  const x = d.length / 2, y = d.width / 2, depth = d.penaltyDepth, half = d.penaltyWidth / 2;
  const box = (sign) => [
    [sign * x, -half, sign * (x - depth), -half], [sign * (x - depth), -half, sign * (x - depth), half],
    [sign * (x - depth), half, sign * x, half]];
  return {
    length: d.length, width: d.width, goalWidth: d.goalWidth, goalDepth: d.goalDepth, goalHeight: d.goalHeight,
    barDiameter: d.goalBarDiameter, ballRadius: d.ballRadius, circle: [0, 0, d.centreCircleRadius],
    lines: [[-x, -y, x, -y], [x, -y, x, y], [x, y, -x, y], [-x, y, -x, -y], [0, -y, 0, y], ...box(1), ...box(-1)],
  };
}

// A slider's reach for a parameter: its range, or what lies around its default where the range says too little.
export function reachOf({ min, max, default: text }) {
  const usual = Math.abs(Number(text)) || 1;
  const low = min === null || min < -20 * usual ? -4 * usual : min;
  const high = max === null || max > 20 * usual ? 4 * usual : max;
  return [Math.max(low, min ?? low), Math.min(high, max ?? high)];
}
