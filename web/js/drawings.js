// What the agents draw: lines, circles, points, spheres, polygons and texts, in named sets.
import * as THREE from '../three/three.module.js';
import { LineSegments2 } from '../three/LineSegments2.js';
import { LineSegmentsGeometry } from '../three/LineSegmentsGeometry.js';
import { LineMaterial } from '../three/LineMaterial.js';

const above = 0.015; // what lies on the ground is drawn so much above it [m]

function parseColour(text) {
  return { colour: new THREE.Color(text.slice(0, 7)), alpha: text.length > 7 ? parseInt(text.slice(7), 16) / 255 : 1 };
}

export class TextSprites {
  constructor() { this.cache = new Map(); }

  make(text, colour) {
    const key = `${colour} ${text}`;
    if (!this.cache.has(key)) {
      if (this.cache.size > 500) {
        for (const old of this.cache.values()) old.texture.dispose();
        this.cache.clear();
      }
      const canvas = document.createElement('canvas');
      const c = canvas.getContext('2d');
      const font = 'bold 40px system-ui, "DejaVu Sans", sans-serif';
      c.font = font;
      const lines = text.split('\n').slice(0, 8).map((line) => line.slice(0, 120));
      canvas.width = Math.max(8, ...lines.map((line) => Math.ceil(c.measureText(line).width))) + 20;
      canvas.height = 50 * lines.length + 10;
      c.font = font;
      c.textBaseline = 'middle';
      c.lineWidth = 6;
      c.strokeStyle = 'rgba(0,0,0,0.7)';
      c.fillStyle = colour;
      lines.forEach((line, i) => {
        c.strokeText(line, 10, 30 + 50 * i);
        c.fillText(line, 10, 30 + 50 * i);
      });
      const texture = new THREE.CanvasTexture(canvas);
      texture.colorSpace = THREE.SRGBColorSpace;
      this.cache.set(key, { texture, aspect: canvas.width / canvas.height, lines: lines.length });
    }
    const { texture, aspect, lines } = this.cache.get(key);
    const sprite = new THREE.Sprite(new THREE.SpriteMaterial({ map: texture, transparent: true, depthTest: false }));
    sprite.userData = { width: lines * aspect, height: lines };
    sprite.renderOrder = 8;
    return sprite;
  }
}

export class Drawings {
  constructor(scene) {
    this.scene = scene;
    this.group = new THREE.Group();
    this.texts = new THREE.Group();
    scene.add(this.group, this.texts);
    this.sprites = new TextSprites();
    this.hidden = new Set();
    this.message = { sets: [], texts: [] };
    this.materials = new Map();
    this.sphereGeometry = new THREE.SphereGeometry(1, 16, 12);
    this.count = 0;
  }

  take(message) {
    this.message = message;
    this.draw();
  }

  hide(name, hide) {
    if (hide) this.hidden.add(name);
    else this.hidden.delete(name);
    this.draw();
  }

  names() { return this.message.sets.map((set) => set.name); }

  lineMaterial(width) {
    const key = Math.max(1, Math.round(width * 2) / 2);
    if (!this.materials.has(key)) this.materials.set(key, new LineMaterial({ vertexColors: true, linewidth: key, fog: true }));
    return this.materials.get(key);
  }

  clear() {
    for (const child of this.group.children) {
      if (child.geometry !== this.sphereGeometry) child.geometry?.dispose();
      if (!child.material.isLineMaterial) child.material.dispose();
    }
    this.group.clear();
    for (const child of this.texts.children) child.material.dispose();
    this.texts.clear();
  }

  draw() {
    this.clear();
    this.count = 0;
    this.lines = new Map(); // by width: positions and colours
    this.dots = new Map(); // by size
    for (const set of this.message.sets) {
      if (this.hidden.has(set.name)) continue;
      for (const [kind, colour, ...v] of set.shapes) {
        this[kind]?.(parseColour(colour), v, colour);
        ++this.count;
      }
    }
    for (const [width, { positions, colours }] of this.lines) {
      const geometry = new LineSegmentsGeometry();
      geometry.setPositions(positions);
      geometry.setColors(colours);
      const mesh = new LineSegments2(geometry, this.lineMaterial(width));
      mesh.frustumCulled = false;
      this.group.add(mesh);
    }
    for (const [size, { positions, colours }] of this.dots) {
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute('position', new THREE.Float32BufferAttribute(positions, 3));
      geometry.setAttribute('color', new THREE.Float32BufferAttribute(colours, 3));
      this.group.add(new THREE.Points(geometry, new THREE.PointsMaterial({ size, sizeAttenuation: false, vertexColors: true })));
    }
    this.agentTexts = this.message.texts.map((text) => {
      const sprite = this.sprites.make(text.text, text.colour);
      this.texts.add(sprite);
      return { ...text, sprite };
    });
  }

  segment(width, a, b, { colour }) {
    const key = Math.max(1, Math.round(width * 2) / 2);
    if (!this.lines.has(key)) this.lines.set(key, { positions: [], colours: [] });
    const { positions, colours } = this.lines.get(key);
    positions.push(...a, ...b);
    colours.push(colour.r, colour.g, colour.b, colour.r, colour.g, colour.b);
  }

  line(colour, [x1, y1, z1, x2, y2, z2, width]) {
    this.segment(width, [x1, y1, Math.max(z1, above)], [x2, y2, Math.max(z2, above)], colour);
  }

  circle(colour, [x, y, radius, width]) {
    const parts = Math.min(96, Math.max(32, Math.round(radius * 24)));
    const at = (i) => [x + radius * Math.cos((2 * Math.PI * i) / parts), y + radius * Math.sin((2 * Math.PI * i) / parts), above];
    for (let i = 0; i < parts; ++i) this.segment(width, at(i), at(i + 1), colour);
  }

  point({ colour }, [x, y, z, size]) {
    if (!this.dots.has(size)) this.dots.set(size, { positions: [], colours: [] });
    const { positions, colours } = this.dots.get(size);
    positions.push(x, y, Math.max(z, above));
    colours.push(colour.r, colour.g, colour.b);
  }

  sphere({ colour }, [x, y, z, radius]) {
    const mesh = new THREE.Mesh(this.sphereGeometry, new THREE.MeshLambertMaterial({ color: colour }));
    mesh.position.set(x, y, z);
    mesh.scale.setScalar(radius);
    this.group.add(mesh);
  }

  polygon({ colour, alpha }, corners) {
    const positions = [];
    const corner = (i) => [corners[3 * i], corners[3 * i + 1], Math.max(corners[3 * i + 2], above)];
    for (let i = 1; i + 1 < corners.length / 3; ++i) positions.push(...corner(0), ...corner(i), ...corner(i + 1));
    if (!positions.length) return;
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.Float32BufferAttribute(positions, 3));
    this.group.add(new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({
      color: colour, transparent: true, opacity: alpha, side: THREE.DoubleSide, depthWrite: false })));
  }

  text(_, [x, y, z, text], colour) {
    const sprite = this.sprites.make(text, colour.slice(0, 7));
    sprite.position.set(x, y, z + 0.1);
    this.group.add(sprite);
  }

  // Texts of agents go along with their robots; all texts keep their size on the screen, but for the nearest.
  follow(shown, camera) {
    for (const text of this.agentTexts ?? []) {
      const robot = shown.robots.find((r) => r.side === text.side && r.unum === text.unum);
      text.sprite.visible = Boolean(robot);
      if (robot) {
        const p = robot.poses.length ? robot.poses : robot.torso;
        const distance = camera.position.distanceTo(text.sprite.position.set(p[0], p[1], p[2]));
        text.sprite.position.z += 0.3 + Math.max(0.14, 0.026 * distance);
      }
    }
    for (const group of [this.group, this.texts]) {
      for (const child of group.children) {
        if (!child.isSprite) continue;
        const size = Math.max(0.06, 0.019 * camera.position.distanceTo(child.position));
        child.scale.set(size * child.userData.width, size * child.userData.height, 1);
      }
    }
  }

  show(visible) { this.group.visible = this.texts.visible = visible; }
}
