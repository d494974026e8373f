// Grass, lines and goals, from the sizes the server tells.
import * as THREE from '../three/three.module.js';
import { makeLines } from './lines.js';

const border = 5;

function random(seed) { // the same grass in every visit
  let state = seed;
  return () => (state = (state * 16807) % 2147483647) / 2147483647;
}

function grassTexture(field) {
  const perMetre = 48, stripes = 12;
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 1024;
  const c = canvas.getContext('2d');
  const next = random(7);
  c.fillStyle = '#3f8a3a';
  c.fillRect(0, 0, 1024, 1024);
  for (let i = 0; i < 60000; ++i) {
    const shade = 45 + 55 * next();
    c.fillStyle = `rgba(${shade * 0.55},${shade * 1.5},${shade * 0.5},0.35)`;
    c.fillRect(1024 * next(), 1024 * next(), 1 + 1.5 * next(), 2 + 4 * next());
  }
  const texture = new THREE.CanvasTexture(canvas);
  texture.colorSpace = THREE.SRGBColorSpace;
  texture.wrapS = texture.wrapT = THREE.RepeatWrapping;
  texture.anisotropy = 8;
  return { texture, repeat: perMetre / 1024 * 4, stripes };
}

function ground(field) {
  const { texture, repeat, stripes } = grassTexture(field);
  const group = new THREE.Group();
  const material = (tint) => new THREE.MeshStandardMaterial({
    map: texture, color: tint, roughness: 1, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 2 });
  const plane = (x, y, width, height, tint, z = 0) => {
    const geometry = new THREE.PlaneGeometry(width, height);
    const uv = geometry.attributes.uv;
    for (let i = 0; i < uv.count; ++i) uv.setXY(i, (x + (uv.getX(i) - 0.5) * width) * repeat, (y + (uv.getY(i) - 0.5) * height) * repeat);
    const mesh = new THREE.Mesh(geometry, material(tint));
    mesh.position.set(x, y, z);
    mesh.receiveShadow = true;
    group.add(mesh);
  };
  const length = field.length + 2 * border, width = field.width + 2 * border, stripe = length / stripes;
  for (let i = 0; i < stripes; ++i) plane(-length / 2 + (i + 0.5) * stripe, 0, stripe, width, i % 2 ? 0xffffff : 0xd8e8cf);
  const around = new THREE.Mesh(new THREE.CircleGeometry(225, 64),
    new THREE.MeshStandardMaterial({ color: 0x3d6f3c, roughness: 1, polygonOffset: true, polygonOffsetFactor: 2, polygonOffsetUnits: 8 }));
  around.position.z = -0.02;
  group.add(around);
  return group;
}

function netTexture() {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 64;
  const c = canvas.getContext('2d');
  c.strokeStyle = 'rgba(255,255,255,0.95)';
  c.lineWidth = 5;
  c.strokeRect(0, 0, 64, 64);
  const texture = new THREE.CanvasTexture(canvas);
  texture.wrapS = texture.wrapT = THREE.RepeatWrapping;
  texture.anisotropy = 8;
  return texture;
}

function goal(field, sign, texture) {
  const group = new THREE.Group();
  const white = new THREE.MeshStandardMaterial({ color: 0xf7f7f4, roughness: 0.5 });
  const radius = field.barDiameter / 2, half = field.goalWidth / 2 + radius, height = field.goalHeight + radius;
  const bar = (a, b, r = radius) => {
    const from = new THREE.Vector3(...a), to = new THREE.Vector3(...b);
    const mesh = new THREE.Mesh(new THREE.CylinderGeometry(r, r, from.distanceTo(to) + r, 14), white);
    mesh.position.copy(from).add(to).multiplyScalar(0.5);
    mesh.quaternion.setFromUnitVectors(new THREE.Vector3(0, 1, 0), to.clone().sub(from).normalize());
    mesh.castShadow = true;
    group.add(mesh);
  };
  const x = sign * field.length / 2, back = x + sign * field.goalDepth, thin = radius * 0.6;
  for (const y of [-half, half]) {
    bar([x, y, 0], [x, y, height]);
    bar([back, y, 0], [back, y, height], thin);
    bar([x, y, height], [back, y, height], thin);
    bar([x, y, thin], [back, y, thin], thin);
  }
  bar([x, -half, height], [x, half, height]);
  bar([back, -half, height], [back, half, height], thin);
  bar([back, -half, thin], [back, half, thin], thin);
  const net = (corners, across, up) => {
    const geometry = new THREE.BufferGeometry();
    const [a, b, c, d] = corners;
    geometry.setAttribute('position', new THREE.Float32BufferAttribute([a, b, c, a, c, d].flat(), 3));
    const u = across / 0.08, v = up / 0.08;
    geometry.setAttribute('uv', new THREE.Float32BufferAttribute([0, 0, u, 0, u, v, 0, 0, u, v, 0, v], 2));
    const mesh = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ map: texture, transparent: true, opacity: 0.6, side: THREE.DoubleSide, depthWrite: false }));
    group.add(mesh);
  };
  net([[back, -half, 0], [back, half, 0], [back, half, height], [back, -half, height]], 2 * half, height);
  net([[x, -half, height], [x, half, height], [back, half, height], [back, -half, height]], 2 * half, field.goalDepth);
  for (const y of [-half, half]) net([[x, y, 0], [back, y, 0], [back, y, height], [x, y, height]], field.goalDepth, height);
  return group;
}

export function makeField(field) {
  const group = new THREE.Group();
  const texture = netTexture();
  group.add(ground(field), makeLines(field), goal(field, -1, texture), goal(field, 1, texture));
  return group;
}
