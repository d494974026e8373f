// The sky: from the horizon's haze, into which the ground fades, up to blue.
import * as THREE from '../three/three.module.js';

export const haze = 0xcfe0ec;

export function makeSky() {
  const geometry = new THREE.SphereGeometry(230, 32, 64);
  const colours = [], low = new THREE.Color(haze), high = new THREE.Color(0x3f7fc4), position = geometry.attributes.position;
  const colour = new THREE.Color();
  for (let i = 0; i < position.count; ++i) {
    const up = Math.max(0, position.getY(i) / 230);
    colour.copy(low).lerp(high, Math.pow(up, 0.75));
    colours.push(colour.r, colour.g, colour.b);
  }
  geometry.setAttribute('color', new THREE.Float32BufferAttribute(colours, 3));
  geometry.rotateX(Math.PI / 2);
  const sky = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({
    vertexColors: true, side: THREE.BackSide, fog: false, depthWrite: false, toneMapped: false }));
  sky.renderOrder = -10;
  return sky;
}
