// Taking a robot or the ball with the mouse and putting it elsewhere on the field.
import * as THREE from '../three/three.module.js';

const reach = 0.3; // how near the pointer has to be [m]

export class Drag {
  constructor({ canvas, camera, cameras, scene, shown, allowed, onMoveRobot, onMoveBall, onSelect }) {
    Object.assign(this, { canvas, camera, cameras, shown, allowed, onMoveRobot, onMoveBall, onSelect });
    this.ray = new THREE.Raycaster();
    this.ground = new THREE.Plane(new THREE.Vector3(0, 0, 1), 0);
    this.ghost = new THREE.Mesh(new THREE.RingGeometry(0.2, 0.26, 40),
      new THREE.MeshBasicMaterial({ color: 0xffffff, transparent: true, opacity: 0.9, depthTest: false }));
    this.ghost.visible = false;
    this.ghost.renderOrder = 6;
    scene.add(this.ghost);
    // Before the camera's own listeners, so that they see that it is not their business.
    const early = { capture: true };
    canvas.addEventListener('pointerdown', (e) => this.down(e), early);
    canvas.addEventListener('pointermove', (e) => this.move(e), early);
    canvas.addEventListener('pointerup', (e) => this.up(e), early);
    canvas.addEventListener('pointercancel', () => this.end(), early);
    canvas.addEventListener('dblclick', (e) => {
      const found = this.pick(e);
      if (found?.robot) this.onSelect(found.robot);
    });
  }

  aim(event) {
    const box = this.canvas.getBoundingClientRect();
    this.ray.setFromCamera(new THREE.Vector2(
      ((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2), this.camera);
    return this.ray.ray;
  }

  place(event, height = 0) {
    this.ground.constant = -height;
    return this.aim(event).intersectPlane(this.ground, new THREE.Vector3());
  }

  // What the pointer is on: the nearest to its ray.
  pick(event) {
    const ray = this.aim(event), shown = this.shown();
    if (!shown) return null;
    let best = null;
    const offer = (p, width, found) => {
      const distance = Math.max(0, ray.distanceToPoint(new THREE.Vector3(p[0], p[1], p[2])) - width);
      if (distance < reach * 0.4 && (!best || distance < best.distance)) best = { ...found, distance, height: p[2] };
    };
    for (const robot of shown.robots) {
      if (!robot.unum) continue;
      offer(robot.poses.length ? robot.poses : robot.torso, 0.12, { robot });
      if (robot.poses.length) offer([robot.poses[0], robot.poses[1], robot.poses[2] * 0.45], 0.1, { robot });
    }
    const away = this.camera.position.distanceTo(new THREE.Vector3(...shown.ball.slice(0, 3)));
    offer(shown.ball, 0.02 + 0.004 * away, { ball: true });
    return best;
  }

  down(event) {
    if (event.button !== 0 || !this.allowed()) return;
    const found = this.pick(event);
    if (!found) return;
    this.held = found;
    this.moved = false;
    const at = this.place(event, found.height);
    const p = found.ball ? this.shown().ball : found.robot.poses.length ? found.robot.poses : found.robot.torso;
    found.offset = at ? [p[0] - at.x, p[1] - at.y] : [0, 0];
    this.cameras.controls.enabled = false;
    try { this.canvas.setPointerCapture(event.pointerId); } catch { /* the pointer is gone already */ }
    event.stopPropagation();
  }

  target(event) {
    const at = this.place(event, this.held.height);
    return at && { x: Math.max(-20, Math.min(20, at.x + this.held.offset[0])), y: Math.max(-14, Math.min(14, at.y + this.held.offset[1])) };
  }

  move(event) {
    if (!this.held) {
      if (event.buttons === 0) this.canvas.style.cursor = this.allowed() && this.pick(event) ? 'grab' : '';
      return;
    }
    event.stopPropagation();
    const to = this.target(event);
    if (!to) return;
    this.moved = true;
    this.canvas.style.cursor = 'grabbing';
    this.ghost.visible = true;
    this.ghost.position.set(to.x, to.y, 0.02);
    this.ghost.scale.setScalar(this.held.ball ? 0.5 : 1);
  }

  up(event) {
    if (!this.held) return;
    event.stopPropagation();
    const to = this.moved && this.target(event);
    if (to && this.held.ball) this.onMoveBall(to.x, to.y);
    if (to && this.held.robot) this.onMoveRobot(this.held.robot, to.x, to.y, this.held.height);
    this.end();
  }

  end() {
    this.held = null;
    this.ghost.visible = false;
    this.canvas.style.cursor = '';
    this.cameras.choose(this.cameras.mode);
  }
}
