// A field seen from above as SVG, on which things are dragged or moved with the arrow keys. x to the right, y up, in metres.
const namespace = 'http://www.w3.org/2000/svg';
const margin = 1.2;

function shape(tag, set, ...children) {
  const element = document.createElementNS(namespace, tag);
  for (const [name, value] of Object.entries(set)) element.setAttribute(name, value);
  element.append(...children);
  return element;
}

export class Pitch {
  constructor({ place, onDrag, onDragged }) {
    Object.assign(this, { onDrag, onDragged, things: new Map() });
    this.svg = shape('svg', { preserveAspectRatio: 'xMidYMid meet' });
    this.lines = shape('g', { class: 'lines' });
    this.marks = shape('g', { class: 'marks' });
    this.top = shape('g', {});
    this.svg.append(shape('g', { transform: 'scale(1,-1)' }, this.lines, this.marks, this.top));
    place.append(this.svg);
  }

  field({ length, width, goalWidth, goalDepth, penaltyDepth, penaltyWidth, centreCircleRadius }) {
    const x = length / 2, y = width / 2;
    this.svg.setAttribute('viewBox', `${-x - margin} ${-y - margin} ${length + 2 * margin} ${width + 2 * margin}`);
    const box = (left, low, wide, high, name = '') => shape('rect', { x: left, y: low, width: wide, height: high, class: name });
    this.lines.replaceChildren(box(-x - margin, -y - margin, length + 2 * margin, width + 2 * margin, 'grass'), box(-x, -y, length, width),
      box(-x, -penaltyWidth / 2, penaltyDepth, penaltyWidth), box(x - penaltyDepth, -penaltyWidth / 2, penaltyDepth, penaltyWidth),
      box(-x - goalDepth, -goalWidth / 2, goalDepth, goalWidth), box(x, -goalWidth / 2, goalDepth, goalWidth, 'theirs'),
      shape('line', { x1: 0, x2: 0, y1: -y, y2: y }), shape('circle', { r: centreCircleRadius }));
  }

  dots(places) { this.marks.replaceChildren(...places.map(([cx, cy]) => shape('circle', { cx, cy, r: 0.12 }))); }

  // A thing with a name, by a key; label: in its circle.
  thing(key, { at: [x, y], label, name, kind, moves }) {
    let thing = this.things.get(key);
    if (!thing) {
      const text = shape('text', { transform: 'scale(1,-1)', class: 'label', y: 0.2 }), title = shape('text', { transform: 'scale(1,-1)', class: 'name', y: 1.05 });
      const group = shape('g', { class: kind, 'data-thing': key }, shape('circle', { r: kind === 'ball' ? 0.28 : 0.5 }), text, title);
      thing = { group, text, title };
      this.things.set(key, thing);
      this.top.append(group);
      if (moves) {
        group.setAttribute('tabindex', 0);
        group.onpointerdown = (event) => this.hold(event, key);
        group.onkeydown = (event) => this.nudge(event, key);
      }
    }
    thing.at = [x, y];
    thing.text.textContent = label;
    thing.title.textContent = name;
    thing.group.setAttribute('aria-label', `${name} ${x.toFixed(2)} ${y.toFixed(2)}`);
    thing.group.setAttribute('transform', `translate(${x} ${y})`);
  }

  drop(keep) {
    for (const [key, { group }] of this.things)
      if (!keep(key)) {
        group.remove();
        this.things.delete(key);
      }
  }

  onField(event) {
    const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(this.svg.getScreenCTM().inverse());
    return [x, -y];
  }

  hold(event, key) {
    if (event.button !== 0) return;
    event.preventDefault();
    const thing = this.things.get(key), from = this.onField(event), by = [thing.at[0] - from[0], thing.at[1] - from[1]];
    thing.group.focus();
    const move = (next) => {
      const [x, y] = this.onField(next);
      this.onDrag(key, [x + by[0], y + by[1]]);
    };
    const stop = () => {
      removeEventListener('pointermove', move);
      removeEventListener('pointerup', stop);
      removeEventListener('pointercancel', stop);
      this.onDragged();
    };
    addEventListener('pointermove', move);
    addEventListener('pointerup', stop);
    addEventListener('pointercancel', stop);
  }

  nudge(event, key) {
    const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
    if (!way || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    const { at } = this.things.get(key), by = event.shiftKey ? 1 : 0.1;
    this.onDrag(key, [at[0] + by * way[0], at[1] + by * way[1]]);
    this.onDragged();
  }
}
