// The white lines: as wide as they are, but never thinner on the screen than a pixel, or they would break up far away and
// on screens of few pixels.
import * as THREE from '../three/three.module.js';

const lineWidth = 0.06, height = 0.004, piece = 0.5; // [m]

// A strip along points of the ground; `closed` joins its ends.
function strip(target, points, closed) {
  const last = points.length - 1;
  const sideAt = (i) => {
    const a = points[closed ? (i + last) % points.length : Math.max(0, i - 1)], b = points[closed ? (i + 1) % points.length : Math.min(last, i + 1)];
    const length = Math.hypot(b[0] - a[0], b[1] - a[1]) || 1;
    return [-(b[1] - a[1]) / length, (b[0] - a[0]) / length];
  };
  const first = target.positions.length / 3;
  points.forEach(([x, y], i) => {
    const [sx, sy] = sideAt(i);
    for (const sign of [1, -1]) {
      target.positions.push(x, y, height);
      target.sides.push(sign * sx, sign * sy, 0);
    }
  });
  for (let i = 0; i < (closed ? points.length : last); ++i) {
    const a = first + 2 * i, b = first + 2 * ((i + 1) % points.length);
    target.index.push(a, a + 1, b, b, a + 1, b + 1);
  }
}

function straight([x1, y1, x2, y2]) {
  const length = Math.hypot(x2 - x1, y2 - y1) || 1, reach = lineWidth / 2 / length; // so that corners close
  const count = Math.max(1, Math.ceil(length / piece)), points = [];
  for (let i = 0; i <= count; ++i) {
    const share = -reach + (1 + 2 * reach) * (i / count);
    points.push([x1 + share * (x2 - x1), y1 + share * (y2 - y1)]);
  }
  return points;
}

function round([x, y, radius]) {
  return Array.from({ length: 120 }, (_, i) => [x + radius * Math.cos((Math.PI * i) / 60), y + radius * Math.sin((Math.PI * i) / 60)]);
}

export function makeLines(field) {
  const target = { positions: [], sides: [], index: [] };
  for (const line of field.lines) strip(target, straight(line), false);
  if (field.circle) strip(target, round(field.circle), true);
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(target.positions, 3));
  geometry.setAttribute('side', new THREE.Float32BufferAttribute(target.sides, 3));
  geometry.setAttribute('normal', new THREE.Float32BufferAttribute(target.positions.map((_, i) => (i % 3 === 2 ? 1 : 0)), 3));
  geometry.setIndex(target.index);
  const pixel = { value: 0.001 }; // size of a pixel at a distance of 1 m [m]
  const material = new THREE.MeshStandardMaterial({ color: 0xf4f6f2, roughness: 0.9 });
  material.onBeforeCompile = (shader) => {
    shader.uniforms.pixel = pixel;
    shader.vertexShader = `attribute vec3 side;\nuniform float pixel;\n${shader.vertexShader.replace('#include <begin_vertex>', `
      #include <begin_vertex>
      vec3 toCamera = cameraPosition - (modelMatrix * vec4(position, 1.0)).xyz;
      float away = length(toCamera);
      vec3 sight = toCamera / away;
      // How much of a step sideways the eye sees.
      float seen = clamp(length(cross(side, sight)), 0.2, 1.0);
      transformed += side * max(${(lineWidth / 2).toFixed(3)}, 0.75 * pixel * away / seen);`)}`;
  };
  const mesh = new THREE.Mesh(geometry, material);
  mesh.receiveShadow = true;
  mesh.frustumCulled = false;
  mesh.onBeforeRender = (renderer, scene, camera) => {
    pixel.value = (2 * Math.tan((camera.fov * Math.PI) / 360)) / renderer.getDrawingBufferSize(new THREE.Vector2()).y;
  };
  return mesh;
}
