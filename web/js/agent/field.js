// The field with what is drawn and the places that are followed; the same grass, lines and shapes as the match page's.
import * as THREE from '../../three/three.module.js';
import { Cameras } from '../cameras.js';
import { Drawings } from '../drawings.js';
import { makeField } from '../field.js';
import { Stage } from '../stage.js';
import { make } from './dom.js';
import { fieldOf, headingOf, placeOf, shortName } from './paths.js';

const colours = ['#ff5ad1', '#5affc8', '#fff35a', '#5ab4ff', '#ff965a', '#b45aff'];
const pause = 1000 / (Number(new URLSearchParams(location.search).get('fps')) || 20); // between two pictures [ms]

export class Field {
  constructor({ canvas, legend, link, onChange }) {
    Object.assign(this, { legend, link, onChange });
    this.stage = new Stage(canvas);
    this.cameras = new Cameras(this.stage.camera, canvas);
    this.drawings = new Drawings(this.stage.scene);
    this.sets = new Map(); // shapes by name
    this.places = new Map(); // by name: {colour, frame, value, watch}
    this.robot = null;
    this.look = 'robot';
    new ResizeObserver(() => { this.stage.resize(); this.changed = true; }).observe(canvas);
    this.cameras.controls.addEventListener('change', () => { this.changed = true; });
    link.watch('representation:RobotPose', '0.1s', (pose) => this.takeRobot(pose));
    this.last = 0;
    requestAnimationFrame((now) => this.animate(now));
  }

  setDimensions(dimensions) {
    if (this.ground) return;
    this.ground = makeField(fieldOf(dimensions));
    this.stage.scene.add(this.ground);
    this.changed = true;
  }

  takeRobot(pose) {
    const at = placeOf(pose);
    if (!at) return;
    if (this.look === 'robot') {
      const target = this.cameras.controls.target, camera = this.stage.camera.position;
      const way = this.robot ? new THREE.Vector3(at[0] - this.robot.at[0], at[1] - this.robot.at[1], 0) : null;
      if (way && way.length() < 1) {
        target.add(way);
        camera.add(way);
      } else {
        this.cameras.look([at[0] - 1.3, at[1] - 1.2, 1.0], [at[0] + 0.1, at[1], 0.25]);
      }
    }
    this.robot = { at, heading: headingOf(pose) ?? 0 };
    this.refresh();
  }

  choose(look) {
    this.look = look;
    this.cameras.mode = '';
    this.cameras.choose(look === 'top' ? 'top' : 'free');
    if (look === 'robot') this.robot = null;
    this.changed = true;
  }

  // What a drawing shows; null: nothing any more.
  show(name, shapes) {
    if (shapes) this.sets.set(name, shapes);
    else this.sets.delete(name);
    this.refresh();
  }

  follows(name) { return this.places.has(name); }

  follow(name, frame = /[rR]elative|Local|Percept|Request/.test(name) ? 'robot' : 'field') {
    if (this.places.has(name)) return this.leave(name);
    const used = [...this.places.values()].map(({ colour }) => colour);
    const place = { colour: colours.find((colour) => !used.includes(colour)) ?? colours[0], frame, value: null };
    this.places.set(name, place);
    place.watch = this.link.watch(name, '0.1s', (value) => {
      place.value = value;
      this.refresh();
    });
    this.showLegend();
  }

  leave(name) {
    this.places.get(name).watch.end();
    this.places.delete(name);
    this.refresh();
    this.showLegend();
  }

  showLegend() {
    this.legend.replaceChildren(...[...this.places].map(([name, place]) => {
      const dot = make('i'), frame = make('select', { title: 'The frame of the value' }, make('option', { textContent: 'field' }), make('option', { textContent: 'robot' }));
      dot.style.background = place.colour;
      frame.value = place.frame;
      frame.onchange = () => { place.frame = frame.value; this.onChange(); };
      const close = make('button', { textContent: '×', title: 'No more', onclick: () => this.leave(name) });
      return make('div', {}, dot, ` ${shortName(name)} `, frame, close);
    }));
    this.onChange();
  }

  // A place in the field's frame, with where it heads to.
  onField({ frame, value }) {
    const at = placeOf(value);
    if (!at || (frame === 'robot' && !this.robot)) return null;
    let heading = headingOf(value);
    if (frame === 'field') return { at, heading };
    const { at: [x, y], heading: turn } = this.robot, c = Math.cos(turn), s = Math.sin(turn);
    if (heading !== null) heading += turn;
    return { at: [x + c * at[0] - s * at[1], y + s * at[0] + c * at[1], at[2]], heading };
  }

  shapesOf(name, place) {
    const there = this.onField(place);
    if (!there) return [];
    const [x, y, z] = there.at, { colour } = place;
    const shapes = [['circle', colour, x, y, 0.08, 3], ['line', colour, x, y, 0, x, y, z + 0.3, 2], ['text', colour, x, y, z + 0.3, shortName(name)]];
    if (there.heading !== null)
      shapes.push(['line', colour, x, y, z, x + 0.4 * Math.cos(there.heading), y + 0.4 * Math.sin(there.heading), z, 3]);
    return shapes;
  }

  refresh() {
    const sets = [...this.sets].map(([name, shapes]) => ({ name, shapes }));
    const places = [...this.places].flatMap(([name, place]) => this.shapesOf(name, place));
    this.message = { sets: [...sets, { name: 'places', shapes: places }], texts: [] };
    this.changed = true;
  }

  animate(now) {
    requestAnimationFrame((next) => this.animate(next));
    if (now - this.last < pause || document.hidden) return;
    const seconds = Math.min(0.2, (now - this.last) / 1000);
    this.last = now;
    this.cameras.update(null, seconds);
    if (!this.changed) return;
    this.changed = false;
    if (this.message) this.drawings.take(this.message);
    this.message = null;
    this.drawings.follow({ robots: [] }, this.stage.camera);
    const { target } = this.cameras.controls;
    this.stage.light(target, this.stage.camera.position.distanceTo(target));
    this.stage.renderer.render(this.stage.scene, this.stage.camera);
  }
}
