// Where one looks from. In every mode but "side" and "top" the mouse turns and zooms.
import * as THREE from '../three/three.module.js';
import { OrbitControls } from '../three/OrbitControls.js';

const smoothing = 5; // per second

export class Cameras {
  constructor(camera, canvas) {
    this.camera = camera;
    this.controls = new OrbitControls(camera, canvas);
    Object.assign(this.controls, { enableDamping: true, dampingFactor: 0.12, maxPolarAngle: 1.53, minDistance: 0.4, maxDistance: 60, zoomToCursor: false });
    this.selected = null; // {side, unum}
    this.goal = new THREE.Vector3();
    this.mode = '';
    this.choose('free');
  }

  choose(mode) {
    const entered = mode !== this.mode;
    this.mode = mode;
    this.controls.enabled = mode !== 'side' && mode !== 'top';
    this.placed = false;
    if (mode === 'free' && entered) this.look([0, -21.5, 15], [0, -0.9, 0]);
    if (mode === 'top') this.look([0, -0.01, 31], [0, 0, 0]);
  }

  look(from, to) {
    this.camera.position.set(...from);
    this.controls.target.set(...to);
    this.camera.lookAt(...to);
  }

  robot(shown) {
    const robots = shown.robots.filter((r) => r.poses.length);
    const wanted = this.selected && robots.find((r) => r.side === this.selected.side && r.unum === this.selected.unum);
    return wanted ?? robots[0];
  }

  update(shown, seconds) {
    const share = 1 - Math.exp(-smoothing * seconds);
    if (shown && this.mode === 'side') this.side(shown.ball, this.placed ? share * 0.5 : 1);
    if (shown && this.mode === 'ball') this.follow(shown.ball, null, share, 2.2);
    if (shown && this.mode === 'robot') {
      const robot = this.robot(shown);
      if (robot) this.follow(robot.poses, robot, share, 1.7);
    }
    if (this.controls.enabled) this.controls.update(seconds);
  }

  side(ball, share) {
    this.placed = true;
    this.goal.set(ball[0] * 0.75, -15 + ball[1] * 0.25, 7.5);
    this.camera.position.lerp(this.goal, share);
    this.goal.set(ball[0] * 0.92, ball[1] * 0.6 - 0.5, 0);
    this.controls.target.lerp(this.goal, share);
    this.camera.lookAt(this.controls.target);
  }

  follow(p, robot, share, distance) {
    const target = this.goal.set(p[0], p[1], Math.max(0.15, p[2]));
    if (!this.placed) {
      this.placed = true;
      const heading = robot ? Math.atan2(2 * (p[6] * p[5] + p[3] * p[4]), 1 - 2 * (p[4] * p[4] + p[5] * p[5])) : Math.PI / 2;
      this.look([p[0] - distance * Math.cos(heading), p[1] - distance * Math.sin(heading), target.z + distance * 0.45], target.toArray());
      return;
    }
    const way = target.clone().sub(this.controls.target).multiplyScalar(share);
    this.controls.target.add(way);
    this.camera.position.add(way);
  }
}
