// The robots' bodies, as the server describes them. All bodies of one form are one instanced mesh, so a full game
// takes some twenty draw calls.
import * as THREE from '../three/three.module.js';
import { RoundedBoxGeometry } from '../three/RoundedBoxGeometry.js';
import { poseSize } from './frame.js';
import { bonesOf } from './bones.js';
import { cssColour, teamColours } from './teams.js';

const white = 0xf1f3f2, grey = 0x9aa3a8, dark = 0x2b3035, joint = 0x555d63;
const inTeamColour = /torso|UpperArm|Thigh|Foot/;

function makeGeometry({ shape, size }) {
  if (shape === 'box') return new RoundedBoxGeometry(size[0], size[1], size[2], 2, Math.min(...size) * 0.18);
  if (shape === 'capsule') return new THREE.CapsuleGeometry(size[0], size[1], 6, 14).rotateX(Math.PI / 2);
  return new THREE.SphereGeometry(size[0], size[0] > 0.03 ? 28 : 10, size[0] > 0.03 ? 18 : 8);
}

function colourOf(part, side) {
  if (inTeamColour.test(part.name)) return teamColours[side];
  if (part.shape === 'sphere' && part.size[0] < 0.03) return dark;
  return part.shape === 'capsule' ? grey : white;
}

function numberTexture(number, side, round) {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 128;
  const c = canvas.getContext('2d');
  if (round) {
    c.fillStyle = cssColour(teamColours[side]);
    c.globalAlpha = 0.88;
    c.beginPath();
    c.arc(64, 64, 56, 0, 2 * Math.PI);
    c.fill();
    c.globalAlpha = 1;
  }
  c.fillStyle = 'white';
  c.font = `bold ${round ? 72 : 104}px system-ui, "DejaVu Sans", sans-serif`;
  c.textAlign = 'center';
  c.textBaseline = 'middle';
  c.fillText(String(number), 64, round ? 69 : 72);
  const texture = new THREE.CanvasTexture(canvas);
  texture.colorSpace = THREE.SRGBColorSpace;
  texture.anisotropy = 4;
  return texture;
}

function turnTo(direction) {
  return new THREE.Quaternion().setFromUnitVectors(new THREE.Vector3(0, 0, 1), new THREE.Vector3(...direction));
}

// A number on breast and back of a torso of this size.
function numberGeometry([depth, width]) {
  const side = width * 0.78, x = depth / 2 + 0.0015;
  const front = new THREE.PlaneGeometry(side, side).rotateX(Math.PI / 2).rotateZ(Math.PI / 2).translate(x, 0, 0.02);
  const back = new THREE.PlaneGeometry(side, side).rotateX(Math.PI / 2).rotateZ(-Math.PI / 2).translate(-x, 0, 0.02);
  const merged = new THREE.BufferGeometry();
  for (const name of ['position', 'normal', 'uv']) {
    const size = front.attributes[name].itemSize;
    merged.setAttribute(name, new THREE.Float32BufferAttribute(
      [...front.attributes[name].array, ...back.attributes[name].array], size));
  }
  merged.setIndex([...front.index.array, ...[...back.index.array].map((i) => i + 4)]);
  return merged;
}

export class Robots {
  constructor(scene, types) {
    this.scene = scene;
    this.types = types;
    this.group = new THREE.Group();
    this.labels = new THREE.Group();
    scene.add(this.group, this.labels);
    this.textures = new Map();
    this.robots = [];
    this.matrix = new THREE.Matrix4();
    this.position = new THREE.Vector3();
    this.rotation = new THREE.Quaternion();
    this.offset = new THREE.Vector3();
    this.one = new THREE.Vector3(1, 1, 1);
  }

  texture(number, side, round) {
    const key = `${number} ${round ? teamColours[side] : ''} ${round}`;
    if (!this.textures.has(key)) this.textures.set(key, numberTexture(number, side, round));
    return this.textures.get(key);
  }

  clear() {
    for (const mesh of this.group.children) {
      mesh.geometry.dispose();
      mesh.material.dispose();
      mesh.dispose?.();
    }
    for (const label of this.labels.children) label.material.dispose();
    this.group.clear();
    this.labels.clear();
  }

  // Who is there has changed: every body gets its place in an instanced mesh.
  setRobots(robots) {
    this.clear();
    const forms = new Map();
    const slot = (part, colour) => {
      const key = JSON.stringify([part.shape, part.size]);
      if (!forms.has(key)) forms.set(key, { part, slots: [] });
      const place = { form: forms.get(key), index: forms.get(key).slots.length };
      place.form.slots.push(colour);
      return place;
    };
    this.robots = robots.map((robot) => {
      const parts = robot.poses.length ? this.types[robot.type].parts : [];
      const places = [];
      parts.forEach((part, i) => {
        places.push({ ...slot(part, colourOf(part, robot.side)), pose: i });
        for (const bone of bonesOf(part)) {
          const form = bone.length < 1e-3 ? { shape: 'sphere', size: [bone.radius] } : { shape: 'capsule', size: [bone.radius, Number(bone.length.toFixed(4))] };
          places.push({ ...slot(form, joint), pose: i, offset: new THREE.Vector3(...bone.middle), turn: turnTo(bone.direction) });
        }
        if (part.name === 'head') { // eyes, so that one sees where it looks
          const r = part.size[0];
          const visor = { shape: 'box', size: [r * 0.5, r * 1.35, r * 0.42] };
          places.push({ ...slot(visor, dark), pose: i, offset: new THREE.Vector3(r * 0.79, 0, r * 0.15) });
        }
      });
      return { ...robot, places, number: this.addNumber(robot, parts[0]), label: this.addLabel(robot) };
    });
    for (const form of forms.values()) {
      form.mesh = new THREE.InstancedMesh(makeGeometry(form.part),
        new THREE.MeshStandardMaterial({ roughness: 0.55, metalness: 0.05 }), form.slots.length);
      form.mesh.castShadow = form.mesh.receiveShadow = true;
      form.mesh.frustumCulled = false;
      const colour = new THREE.Color();
      form.slots.forEach((c, i) => form.mesh.setColorAt(i, colour.set(c)));
      this.group.add(form.mesh);
    }
    this.forms = forms;
  }

  addNumber(robot, torso) {
    if (!torso || !robot.unum) return null;
    const mesh = new THREE.Mesh(numberGeometry(torso.size),
      new THREE.MeshBasicMaterial({ map: this.texture(robot.unum, robot.side, false), transparent: true, depthWrite: false }));
    this.group.add(mesh);
    return mesh;
  }

  addLabel(robot) {
    const label = new THREE.Sprite(new THREE.SpriteMaterial({
      map: this.texture(robot.unum || '?', robot.side, true), depthTest: false, transparent: true }));
    label.renderOrder = 5;
    this.labels.add(label);
    return label;
  }

  pose(robots, camera) {
    robots.forEach((robot, n) => {
      const own = this.robots[n];
      const p = robot.poses;
      for (const place of own.places) {
        const i = place.pose * poseSize;
        this.position.set(p[i], p[i + 1], p[i + 2]);
        this.rotation.set(p[i + 3], p[i + 4], p[i + 5], p[i + 6]);
        if (place.offset) this.position.add(this.offset.copy(place.offset).applyQuaternion(this.rotation));
        if (place.turn) this.rotation.multiply(place.turn);
        place.form.mesh.setMatrixAt(place.index, this.matrix.compose(this.position, this.rotation, this.one));
      }
      if (own.number) {
        own.number.position.set(p[0], p[1], p[2]);
        own.number.quaternion.set(p[3], p[4], p[5], p[6]);
      }
      const at = p.length ? p : robot.torso;
      own.label.position.set(at[0], at[1], at[2]);
      const distance = camera.position.distanceTo(own.label.position);
      const size = Math.max(0.1, 0.016 * distance);
      own.label.position.z += 0.28 + 0.6 * size;
      own.label.scale.setScalar(size);
      own.label.visible = distance > 2.5;
    });
    for (const form of this.forms?.values() ?? []) form.mesh.instanceMatrix.needsUpdate = true;
  }

  // Bodies in the scene, for whoever counts.
  numBodies() {
    return this.robots.reduce((sum, robot) => sum + (robot.poses.length / poseSize), 0);
  }
}
