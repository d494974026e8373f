// The motion that was found, played in the simulator: red where the search began, blue what it has now.
import * as THREE from '../../three/three.module.js';
import { Cameras } from '../cameras.js';
import { blendPoses, poseSize } from '../frame.js';
import { Robots } from '../robots.js';
import { Stage } from '../stage.js';

const $ = (id) => document.getElementById(id);
const apart = 0.9; // [m]
const pause = 1000 / (Number(new URLSearchParams(location.search).get('fps')) || 30); // between two pictures [ms]

export class Film {
  constructor(canvas) {
    this.canvas = canvas;
    this.films = {}; // start, found
    this.time = 0;
    this.playing = true;
    this.none('The robot appears when the first generation is evaluated.');
    $('filmPlay').onclick = () => { this.playing = !this.playing; $('filmPlay').textContent = this.playing ? '❚❚' : '▶'; };
    $('filmTime').oninput = () => { this.time = Number($('filmTime').value); this.playing = false; $('filmPlay').textContent = '▶'; };
  }

  expect(task) { this.task = task; }
  setTypes(types) { this.types = types; }

  none(why) {
    if (this.stage) return;
    $('noFilm').hidden = false;
    $('noFilm').textContent = why;
  }

  take(film) {
    if (!film.frames.length) return;
    if (!this.stage) this.build(film.type);
    this.films[film.name === 'start' ? 'start' : 'found'] = film;
    $('filmTime').max = this.seconds;
    const label = (side, { name, seconds }) => { const span = document.createElement('span'), dot = document.createElement('i'); dot.style.background = `var(--${side})`; span.append(dot, `${name}: ${seconds.toFixed(2)} s, then it walks`); return span; };
    const { start, found } = this.films;
    $('filmLegend').replaceChildren(...(found ? [label('left', found)] : []), ...(start ? [label('right', start)] : []));
  }

  get seconds() { return Math.max(0, ...Object.values(this.films).map(({ frames, step }) => (frames.length - 1) * step)); }
  state() { return { seconds: this.seconds, time: this.time, films: Object.keys(this.films) }; }

  build(type) {
    $('noFilm').hidden = true;
    this.stage = new Stage(this.canvas);
    this.cameras = new Cameras(this.stage.camera, this.canvas);
    this.cameras.look([1.9, -1.3, 0.95], [0.15, 0, 0.2]);
    const ground = new THREE.Mesh(new THREE.CircleGeometry(60, 48), new THREE.MeshStandardMaterial({ color: 0x4a6152, roughness: 1 }));
    ground.receiveShadow = true;
    const grid = new THREE.GridHelper(10, 50, 0x8fa397, 0x64796c);
    grid.rotation.x = Math.PI / 2;
    grid.position.z = 0.002;
    this.stage.scene.add(ground, grid);
    const { parts } = this.types[type];
    this.robots = new Robots(this.stage.scene, [{ parts }]);
    this.robots.labels.visible = false; // two robots without numbers
    const figure = (side) => ({ side, unum: 0, type: 0, torso: [0, 0, 0], poses: new Float32Array(parts.length * poseSize) });
    this.shown = { found: figure('left'), start: figure('right') };
    new ResizeObserver(() => this.stage.resize()).observe(this.canvas);
    this.last = performance.now();
    requestAnimationFrame((now) => this.animate(now));
  }

  // Beside each other, and where each began is the middle.
  pose(figure, { frames, step }, y) {
    const at = Math.min(this.time / step, frames.length - 1), index = Math.floor(at);
    blendPoses(figure.poses, frames[index], frames[Math.min(index + 1, frames.length - 1)], at - index);
    const [x0, y0] = frames[0];
    for (let i = 0; i < figure.poses.length; i += poseSize) {
      figure.poses[i] -= x0;
      figure.poses[i + 1] += y - y0;
    }
  }

  animate(now) {
    requestAnimationFrame((next) => this.animate(next));
    if (now - this.last < pause || document.hidden) return;
    const seconds = Math.min(0.2, (now - this.last) / 1000);
    this.last = now;
    if (this.playing) this.time = this.time > this.seconds + 0.6 ? 0 : this.time + seconds * Number($('filmSpeed').value);
    const names = ['found', 'start'].filter((name) => this.films[name]);
    const key = names.join();
    if (key !== this.key) {
      this.key = key;
      this.robots.setRobots(names.map((name) => this.shown[name]));
    }
    names.forEach((name, i) => this.pose(this.shown[name], this.films[name], names.length > 1 ? (i ? -apart / 2 : apart / 2) : 0));
    this.cameras.update(null, seconds);
    this.robots.pose(names.map((name) => this.shown[name]), this.stage.camera);
    if (this.playing) $('filmTime').value = Math.min(this.time, this.seconds);
    $('filmClock').textContent = `${Math.min(this.time, this.seconds).toFixed(2)} of ${this.seconds.toFixed(2)} s`;
    const { target } = this.cameras.controls;
    this.stage.light(target, this.stage.camera.position.distanceTo(target));
    this.stage.renderer.render(this.stage.scene, this.stage.camera);
  }
}
