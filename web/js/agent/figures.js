// Two robots beside each other: blue as the sliders say, red as it is now.
import * as THREE from '../../three/three.module.js';
import { Cameras } from '../cameras.js';
import { poseSize } from '../frame.js';
import { Robots } from '../robots.js';
import { Stage } from '../stage.js';

const apart = 0.55; // between the two [m]
const lying = { up: [0, 0, 0], front: [0, Math.PI / 2, 0], back: [0, -Math.PI / 2, 0] };
const pause = 1000 / (Number(new URLSearchParams(location.search).get('fps')) || 25); // between two pictures [ms]
const radians = Math.PI / 180;

function matrixOf({ rotation: r, translation: t }) {
  return new THREE.Matrix4().set(...r[0], t.x, ...r[1], t.y, ...r[2], t.z, 0, 0, 0, 1);
}

function partOf({ name, shape, size, T_link_shape, origin, parent }, index, links) {
  const into = matrixOf(T_link_shape).invert();
  const place = ({ x, y, z }) => new THREE.Vector3(x, y, z).applyMatrix4(into).toArray();
  const joints = [...(parent >= 0 ? [{ x: 0, y: 0, z: 0 }] : []), ...links.filter((link) => link.parent === index).map((link) => link.origin)].map(place);
  return { name, shape, joints, size: shape === 'box' ? [size.x, size.y, size.z] : shape === 'capsule' ? [size.x, size.z] : [size.x] };
}

export class Figures {
  constructor(canvas, links) {
    this.links = links;
    this.shapes = links.map(({ T_link_shape }) => matrixOf(T_link_shape));
    this.stage = new Stage(canvas);
    this.cameras = new Cameras(this.stage.camera, canvas);
    this.cameras.look([1.75, -0.4, 0.75], [0, 0, 0.27]);
    this.stage.scene.add(...this.floor());
    this.robots = new Robots(this.stage.scene, [{ parts: links.map(partOf) }]);
    const figure = (side) => ({ side, unum: 0, type: 0, torso: [0, 0, 0], poses: new Float32Array(links.length * poseSize) });
    this.shown = [figure('left'), figure('right')];
    this.robots.setRobots(this.shown);
    this.robots.labels.visible = false; // two robots without numbers
    this.posture = 'up';
    new ResizeObserver(() => { this.stage.resize(); this.changed = true; }).observe(canvas);
    this.cameras.controls.addEventListener('change', () => { this.changed = true; });
    this.last = 0;
    requestAnimationFrame((now) => this.animate(now));
  }

  floor() {
    const ground = new THREE.Mesh(new THREE.CircleGeometry(40, 48), new THREE.MeshStandardMaterial({ color: 0x4a6152, roughness: 1 }));
    ground.receiveShadow = true;
    const grid = new THREE.GridHelper(6, 60, 0x8fa397, 0x64796c);
    grid.rotation.x = Math.PI / 2;
    grid.position.z = 0.001;
    return [ground, grid];
  }

  // degrees: by joint.
  wanted(degrees) {
    const places = [];
    this.links.forEach(({ parent, joint, origin, axis }, i) => {
      const own = new THREE.Matrix4().makeRotationAxis(new THREE.Vector3(axis.x, axis.y, axis.z), radians * (degrees[joint] ?? 0));
      own.setPosition(origin.x, origin.y, origin.z);
      places[i] = parent < 0 ? new THREE.Matrix4() : places[parent].clone().multiply(own);
    });
    this.place(this.shown[0], places, new THREE.Matrix4().makeRotationFromEuler(new THREE.Euler(...lying[this.posture])), apart / 2);
  }

  // FKModel's links and TorsoPose's torso.
  now(links, torso) {
    const turn = matrixOf({ ...torso, translation: { x: 0, y: 0, z: 0 } });
    this.place(this.shown[1], links.map(matrixOf), turn, -apart / 2);
  }

  // On the ground, beside the other one.
  place(figure, places, turn, y) {
    const world = places.map((link, i) => turn.clone().multiply(link).multiply(this.shapes[i]));
    const corner = new THREE.Vector3();
    let lowest = Infinity;
    world.forEach((matrix, i) => {
      const { size, shape } = this.links[i], half = shape === 'box' ? [size.x / 2, size.y / 2, size.z / 2] : null;
      if (!half) lowest = Math.min(lowest, matrix.elements[14] - size.x);
      else for (let c = 0; c < 8; ++c) lowest = Math.min(lowest, corner.set(...half.map((h, k) => (c >> k & 1 ? h : -h))).applyMatrix4(matrix).z);
    });
    const at = new THREE.Vector3(), q = new THREE.Quaternion(), one = new THREE.Vector3();
    world.forEach((matrix, i) => {
      matrix.decompose(at, q, one);
      figure.poses.set([at.x, at.y + y, at.z - lowest, q.x, q.y, q.z, q.w], i * poseSize);
    });
    this.changed = true;
  }

  lie(posture) { this.posture = posture; }

  animate(now) {
    requestAnimationFrame((next) => this.animate(next));
    if (now - this.last < pause || document.hidden || !this.stage.renderer.domElement.clientWidth) return;
    const seconds = Math.min(0.2, (now - this.last) / 1000);
    this.last = now;
    this.cameras.update(null, seconds);
    if (!this.changed) return;
    this.changed = false;
    this.robots.pose(this.shown, this.stage.camera);
    const { target } = this.cameras.controls;
    this.stage.light(target, this.stage.camera.position.distanceTo(target));
    this.stage.renderer.render(this.stage.scene, this.stage.camera);
  }
}
