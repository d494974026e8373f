// How what is drawn looks from afar: node --test tests/e2e/web/looks.test.mjs, after `make web`, as three.js is part of it.
import assert from 'node:assert/strict';
import { cpSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test from 'node:test';
import { pathToFileURL } from 'node:url';

// A copy of the page whose scripts are modules to every Node.js.
const page = mkdtempSync(join(tmpdir(), 'page-'));
process.on('exit', () => rmSync(page, { recursive: true }));
cpSync(new URL('../../../build/web', import.meta.url), page, { recursive: true });
writeFileSync(join(page, 'package.json'), '{"type": "module"}');
const script = (name) => import(pathToFileURL(join(page, name)));
const { Ball } = await script('js/ball.js');
const { Drawings } = await script('js/drawings.js');
const { makeLines } = await script('js/lines.js');
const THREE = await script('three/three.module.js');

// How far the sides of a polygon around a centre are from the circle through its corners [m].
function flattest(corners, [x, y], radius) {
  return Math.max(...corners.map((a, i) => {
    const b = corners[(i + 1) % corners.length];
    return radius - Math.hypot((a[0] + b[0]) / 2 - x, (a[1] + b[1]) / 2 - y);
  }));
}
function isOn(corners, [x, y], radius) {
  for (const p of corners) assert.ok(Math.abs(Math.hypot(p[0] - x, p[1] - y) - radius) < 1e-5, `${p} is not on the circle`);
}

test('the centre circle is round, to a millimetre, and closed', () => {
  const mesh = makeLines({ lines: [], circle: [1, -2, 2] });
  const { position } = mesh.geometry.attributes;
  const corners = [];
  for (let i = 0; i < position.count; i += 2) corners.push([position.getX(i), position.getY(i)]); // each stands there for two edges
  isOn(corners, [1, -2], 2);
  assert.ok(flattest(corners, [1, -2], 2) < 0.001);
  const last = [...mesh.geometry.index.array.slice(-6)];
  assert.ok(last.includes(0) && last.includes(1), 'the last piece ends where the first begins');
});

test('circles that agents draw are round, to six millimetres, and closed', () => {
  for (const radius of [0.05, 0.3, 1, 2, 5, 10]) {
    const drawings = new Drawings(new THREE.Scene());
    drawings.take({ sets: [{ name: 'a', shapes: [['circle', '#ff0000', 3, 4, radius, 2]] }], texts: [] });
    const { positions } = drawings.lines.get(2), corners = [];
    for (let i = 0; i < positions.length; i += 6) {
      corners.push([positions[i], positions[i + 1]]);
      const next = (i + 6) % positions.length;
      assert.ok(Math.hypot(positions[i + 3] - positions[next], positions[i + 4] - positions[next + 1]) < 1e-9, 'a piece ends where the next begins');
    }
    isOn(corners, [3, 4], radius);
    assert.ok(corners.length >= 32, `a circle of ${radius} m has ${corners.length} corners`);
    assert.ok(flattest(corners, [3, 4], radius) < 0.006, `a circle of ${radius} m is flat`);
  }
});

test('the ball is ten pixels wide at least on a page of 600 lines, and as large as it is when near', () => {
  const pixels = { createImageData: (width, height) => ({ data: new Uint8ClampedArray(4 * width * height) }), putImageData() {} };
  globalThis.document = { createElement: () => ({ getContext: () => pixels }) };
  const ball = new Ball(new THREE.Scene(), 0.042);
  delete globalThis.document;
  const camera = new THREE.PerspectiveCamera(42, 1.6, 0.05, 250); // that of stage.js
  camera.up.set(0, 0, 1);
  const width = (distance) => {
    camera.position.set(0, -distance, 0.042);
    camera.lookAt(0, 0, 0.042);
    camera.updateMatrixWorld();
    ball.pose([0, 0, 0.042, 0, 0, 0, 1], camera, 0);
    const across = (x) => 480 * ball.mesh.position.clone().setX(x).project(camera).x;
    const radius = ball.mesh.scale.x * ball.radius;
    return across(radius) - across(-radius);
  };
  for (const distance of [2, 5, 10, 20, 40, 100]) assert.ok(width(distance) >= 10, `at ${distance} m it has ${width(distance)} pixels`);
  width(2);
  assert.equal(ball.mesh.scale.x, 1);
  width(40);
  assert.ok(ball.mesh.position.z - ball.mesh.scale.x * ball.radius > -1e-6, 'a ball drawn larger still lies on the grass');
});
