// The ball with a dark outline, its trail, and a ring on the grass that shows from afar where it is.
import * as THREE from '../three/three.module.js';
import { Trail } from './trail.js';

const smallest = 0.0065; // its radius on the screen, per distance: far balls are drawn larger than they are

function ballTexture() {
  const canvas = document.createElement('canvas');
  canvas.width = 512;
  canvas.height = 256;
  const c = canvas.getContext('2d');
  const g = (1 + Math.sqrt(5)) / 2;
  const spots = [];
  for (const s of [-1, 1]) for (const t of [-g, g]) spots.push([0, s, t], [s, t, 0], [t, 0, s]);
  const image = c.createImageData(512, 256);
  const n = Math.hypot(1, g);
  for (let v = 0; v < 256; ++v) {
    for (let u = 0; u < 512; ++u) {
      const polar = (Math.PI * (v + 0.5)) / 256, around = (2 * Math.PI * u) / 512;
      const p = [-Math.cos(around) * Math.sin(polar), Math.cos(polar), Math.sin(around) * Math.sin(polar)];
      const near = Math.max(...spots.map((s) => (s[0] * p[0] + s[1] * p[1] + s[2] * p[2]) / n));
      const dark = near > 0.935 ? 34 : 244;
      image.data.set([dark, dark, dark + 3, 255], 4 * (512 * v + u));
    }
  }
  c.putImageData(image, 0, 0);
  const texture = new THREE.CanvasTexture(canvas);
  texture.colorSpace = THREE.SRGBColorSpace;
  return texture;
}

export class Ball {
  constructor(scene, radius) {
    this.radius = radius;
    this.mesh = new THREE.Mesh(new THREE.SphereGeometry(radius, 32, 20),
      new THREE.MeshStandardMaterial({ map: ballTexture(), roughness: 0.45, emissive: 0xffffff, emissiveIntensity: 0.12 }));
    this.mesh.castShadow = true;
    this.outline = new THREE.Mesh(new THREE.SphereGeometry(radius, 24, 16),
      new THREE.MeshBasicMaterial({ color: 0x101418, side: THREE.BackSide }));
    this.ring = new THREE.Mesh(new THREE.RingGeometry(0.84, 1, 48),
      new THREE.MeshBasicMaterial({ color: 0xffe24a, transparent: true, opacity: 0.9, depthWrite: false, toneMapped: false }));
    this.trail = new Trail(scene);
    scene.add(this.mesh, this.outline, this.ring);
  }

  resize(radius) {
    if (radius === this.radius) return;
    this.radius = radius;
    this.mesh.geometry = new THREE.SphereGeometry(radius, 32, 20);
    this.outline.geometry = new THREE.SphereGeometry(radius, 24, 16);
  }

  pose(p, camera, now) {
    this.mesh.position.set(p[0], p[1], p[2]);
    const distance = camera.position.distanceTo(this.mesh.position);
    const scale = Math.max(1, (smallest * distance) / this.radius);
    this.mesh.position.z += (scale - 1) * this.radius;
    this.mesh.quaternion.set(p[3], p[4], p[5], p[6]);
    this.mesh.scale.setScalar(scale);
    this.outline.position.copy(this.mesh.position);
    this.outline.scale.setScalar(scale + (0.0016 * distance) / this.radius);
    this.ring.visible = distance > 5;
    this.ring.position.set(p[0], p[1], 0.012);
    this.ring.scale.setScalar(0.014 * distance + 0.05);
    this.trail.pose(p, camera, now);
  }
}
