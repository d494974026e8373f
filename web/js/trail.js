// Where the ball went in the last two seconds: a ribbon on the grass that fades.
import * as THREE from '../three/three.module.js';

const memory = 2000, jump = 1.5, most = 120; // [ms], [m], points

export class Trail {
  constructor(scene) {
    this.points = [];
    this.positions = new Float32Array(6 * most);
    this.colours = new Float32Array(8 * most).fill(1);
    const index = [];
    for (let i = 0; i + 1 < most; ++i) index.push(2 * i, 2 * i + 1, 2 * i + 2, 2 * i + 2, 2 * i + 1, 2 * i + 3);
    this.geometry = new THREE.BufferGeometry();
    this.geometry.setAttribute('position', new THREE.BufferAttribute(this.positions, 3));
    this.geometry.setAttribute('color', new THREE.BufferAttribute(this.colours, 4));
    this.geometry.setIndex(index);
    this.mesh = new THREE.Mesh(this.geometry, new THREE.MeshBasicMaterial({
      vertexColors: true, transparent: true, depthWrite: false, side: THREE.DoubleSide, toneMapped: false }));
    this.mesh.frustumCulled = false;
    scene.add(this.mesh);
  }

  pose(p, camera, now) {
    const last = this.points.at(-1);
    if (last && Math.hypot(p[0] - last.x, p[1] - last.y) > jump) this.points = [];
    if (!last || Math.hypot(p[0] - last.x, p[1] - last.y) > 0.01) this.points.push({ x: p[0], y: p[1], at: now });
    while (this.points.length && (now - this.points[0].at > memory || this.points.length > most)) this.points.shift();
    const half = 0.012 + 0.0022 * camera.position.distanceTo(new THREE.Vector3(p[0], p[1], p[2]));
    this.points.forEach(({ x, y, at }, i) => {
      const a = this.points[Math.max(0, i - 1)], b = this.points[Math.min(this.points.length - 1, i + 1)];
      const length = Math.hypot(b.x - a.x, b.y - a.y) || 1;
      const sx = (-(b.y - a.y) / length) * half, sy = ((b.x - a.x) / length) * half;
      this.positions.set([x + sx, y + sy, 0.01, x - sx, y - sy, 0.01], 6 * i);
      const strength = 0.7 * (1 - (now - at) / memory);
      this.colours[8 * i + 3] = this.colours[8 * i + 7] = strength;
    });
    this.geometry.attributes.position.needsUpdate = this.geometry.attributes.color.needsUpdate = true;
    this.geometry.setDrawRange(0, 6 * Math.max(0, this.points.length - 1));
  }
}
