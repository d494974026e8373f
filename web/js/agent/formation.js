// The formation while it is edited: a table for each place by where the ball is, undo, and where a place is for any ball.
// Knows no page. What it works out between the balls of the table is what FormationTable does.
const most = 200; // steps that can be undone
const step = 0.05; // of what is written [m]

const copy = (places) => places.map(({ name, x, y }) => ({ name, x: x.map((row) => [...row]), y: y.map((row) => [...row]) }));
const rounded = (value) => Number((Math.round(value / step) * step).toFixed(2));

// The interval that holds a value, and how far into it: 0 to 1.
function between(values, value) {
  const last = values.length - 2;
  let i = values.findIndex((next, k) => k > 0 && value < next) - 1;
  if (i < 0) i = value < values[0] ? 0 : last;
  return [i, Math.min(1, Math.max(0, (value - values[i]) / (values[i + 1] - values[i])))];
}

export function otherSide(name) {
  if (name.startsWith('left')) return `right${name.slice(4)}`;
  return name.startsWith('right') ? `left${name.slice(5)}` : name;
}

export class FormationModel {
  // file: what `get formation` says.
  constructor(file) {
    this.take(file);
    this.places = copy(file.places);
    this.past = [];
    this.future = [];
  }

  take(file) {
    Object.assign(this, { revision: file.revision, ballX: file.ballX, ballY: file.ballY, saved: copy(file.places) });
  }

  get changed() { return JSON.stringify(this.places) !== JSON.stringify(this.saved); }
  mirror(index) { return this.places.findIndex(({ name }) => name === otherSide(this.places[index].name)); }

  // The four cells around a ball with their shares: [row, column, share].
  cells([x, y]) {
    const [i, a] = between(this.ballX, x), [j, b] = between(this.ballY, Math.abs(y));
    return [[j, i, (1 - a) * (1 - b)], [j, i + 1, a * (1 - b)], [j + 1, i, (1 - a) * b], [j + 1, i + 1, a * b]].filter(([, , share]) => share > 0);
  }

  // Where a place is for a ball; one on the right is the mirror image.
  at(index, ball) {
    const right = ball[1] < 0, { x, y } = this.places[right ? this.mirror(index) : index], cells = this.cells(ball);
    const mean = (table) => cells.reduce((sum, [j, i, share]) => sum + share * table[j][i], 0);
    return [mean(x), (right ? -1 : 1) * mean(y)];
  }

  // The ball of the table that is nearest, within reach.
  nearestBall([x, y], reach) {
    const near = (values, value) => values.reduce((best, one) => (Math.abs(one - value) < Math.abs(best - value) ? one : best));
    const on = [near(this.ballX, x), (y < 0 ? -1 : 1) * near(this.ballY, Math.abs(y))];
    return Math.hypot(on[0] - x, on[1] - y) <= reach ? on : null;
  }

  // Puts a place somewhere for this ball, by the least change of the cells around the ball. For a ball in the middle left and right
  // stay mirror images. What has the same mark as the change before is one with it.
  move(index, ball, [toX, toY], mark = null) {
    const before = copy(this.places), right = ball[1] < 0, changed = right ? this.mirror(index) : index;
    const cells = this.cells(ball), squares = cells.reduce((sum, [, , share]) => sum + share * share, 0);
    const [x, y] = this.at(index, ball), table = this.places[changed], other = this.places[this.mirror(changed)];
    for (const [j, i, share] of cells) {
      table.x[j][i] = rounded(table.x[j][i] + ((toX - x) * share) / squares);
      table.y[j][i] = rounded(table.y[j][i] + ((right ? -1 : 1) * (toY - y) * share) / squares);
      if (j > 0) continue;
      if (other === table) table.y[j][i] = 0;
      other.x[j][i] = table.x[j][i];
      other.y[j][i] = other === table ? 0 : -table.y[j][i];
    }
    if (JSON.stringify(before) === JSON.stringify(this.places)) return false;
    if (!mark || mark !== this.mark) this.past = [...this.past, before].slice(-most);
    this.mark = mark;
    this.future = [];
    return true;
  }

  undo() { this.turn(this.past, this.future); }
  redo() { this.turn(this.future, this.past); }
  turn(from, to) {
    if (!from.length) return;
    to.push(copy(this.places));
    this.places = from.pop();
    this.mark = null;
  }

  // As `set` wants it.
  fileText(file) {
    const row = (numbers) => `{${numbers.map((n) => n.toFixed(2)).join(' ')}}`, table = (rows) => `{${rows.map(row).join(' ')}}`;
    const places = this.places.map(({ name, x, y }) => `{${JSON.stringify(name)} ${table(x)} ${table(y)}}`).join(' ');
    return `{${JSON.stringify(file)} "${this.revision}" "" {${this.ballX.join(' ')}} {${this.ballY.join(' ')}} {${places}}}`;
  }
}
