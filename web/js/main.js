// Puts the parts together: what comes from the server, the scene, what the user does.
import * as THREE from '../three/three.module.js';
import { Ball } from './ball.js';
import { Cameras } from './cameras.js';
import { Connection } from './connection.js';
import { Drag } from './drag.js';
import { Drawings } from './drawings.js';
import { makeField } from './field.js';
import { decodeFrame, poseSize } from './frame.js';
import { Hud } from './hud.js';
import { Motion } from './motion.js';
import { Robots } from './robots.js';
import { Stage } from './stage.js';
import { nameTeams } from './teams.js';

const canvas = document.getElementById('view');
const stage = new Stage(canvas);
const cameras = new Cameras(stage.camera, canvas);
const drawings = new Drawings(stage.scene);
const motion = new Motion();
let robots = null, ball = null, field = null, grass = null, shown = null, frames = 0, online = false, drawn = null;

const connection = new Connection({
  onState(open) {
    online = open;
    hud.setOnline(open);
  },
  onMessage(message) {
    if (message.kind === 'geometry') build(message);
    if (message.kind === 'game') takeGame(message);
    if (message.kind === 'replay') takeReplay(message);
    if (message.kind === 'drawings') {
      drawings.take(message);
      hud.showSets(drawings.names(), drawings.hidden);
      if (message.selected) cameras.selected = message.selected;
    }
  },
  onFrame(buffer) {
    const frame = decodeFrame(buffer);
    if (!frame) return;
    const now = performance.now();
    motion.take(frame, now);
    hud.takeTime(frame.time, now);
    ++frames;
  },
});

const hud = new Hud({
  send: (command) => connection.send(command),
  onCamera: (mode) => cameras.choose(mode),
  onLabels: (visible) => { if (robots) robots.labels.visible = visible; },
  onDrawings: (visible) => drawings.show(visible),
  onSet: (name, hide) => drawings.hide(name, hide),
});
hud.camera(new URLSearchParams(location.search).get('camera') ?? 'free');

new Drag({
  canvas, camera: stage.camera, cameras, scene: stage.scene,
  shown: () => shown,
  allowed: () => hud.playable(),
  onMoveRobot: (robot, x, y, z) => connection.send({ do: 'moveRobot', side: robot.side, unum: robot.unum, x, y, z: Math.max(0.05, z) + 0.005 }),
  onMoveBall: (x, y) => connection.send({ do: 'moveBall', x, y, z: field.ballRadius }),
  onSelect(robot) {
    cameras.selected = { side: robot.side, unum: robot.unum };
    hud.camera('robot');
  },
});

// An address may name a moment of a recording, as those of a summary do: #t=12.5
let wanted = new URLSearchParams(location.hash.slice(1)).get('t');
addEventListener('hashchange', () => { wanted = new URLSearchParams(location.hash.slice(1)).get('t'); });
function takeReplay(replay) {
  hud.takeReplay(replay);
  if (wanted === null || !Number.isFinite(Number(wanted))) return;
  connection.send({ do: 'seek', time: Number(wanted) });
  wanted = null;
}

function build(geometry) {
  const drawnField = JSON.stringify(field);
  if (drawnField === JSON.stringify(geometry.field)) return; // the same after a reconnection
  field = geometry.field;
  if (grass) stage.scene.remove(grass); // the simulator has told of another field than the league's
  grass = makeField(field);
  stage.scene.add(grass);
  robots ??= new Robots(stage.scene, geometry.types);
  ball ??= new Ball(stage.scene, field.ballRadius);
  ball.resize(field.ballRadius);
}

function takeGame(game) {
  if (nameTeams(game.left.name, game.right.name)) drawn = null;
  hud.takeGame(game);
}

const pause = 1000 / (Number(new URLSearchParams(location.search).get('fps')) || 1000); // between two pictures [ms]
let last = performance.now(), lastHud = 0;
function animate(now) {
  requestAnimationFrame(animate);
  if (now - last < pause) return;
  const seconds = Math.min(0.2, Math.max(0, (now - last) / 1000));
  last = now;
  if (robots) {
    // Not the picture's own time, which is that of its start: messages may have come since.
    shown = motion.advance(performance.now());
    if (shown) {
      if (drawn !== shown.robots) robots.setRobots(shown.robots);
      drawn = shown.robots;
      ball.pose(shown.ball, stage.camera, now);
      robots.pose(shown.robots, stage.camera);
      drawings.follow(shown, stage.camera);
    }
  }
  cameras.update(shown, seconds);
  stage.light(cameras.controls.target, stage.camera.position.distanceTo(cameras.controls.target));
  stage.render(now);
  if (now - lastHud > 250) {
    hud.tick(now, stage.fps, shown?.robots.length ?? 0);
    lastHud = now;
  }
}
requestAnimationFrame(animate);

function reachOf({ poses }) {
  let reach = 0;
  for (let i = poseSize; i < poses.length; i += poseSize)
    reach = Math.max(reach, Math.hypot(poses[i] - poses[0], poses[i + 1] - poses[1], poses[i + 2] - poses[2]));
  return reach;
}

// For tests and the console: what is on the page.
window.plumbline = {
  state: () => ({
    online, frames,
    bodies: robots?.numBodies() ?? 0,
    // Furthest a body is from its robot's torso [m].
    reach: Math.max(0, ...(shown?.robots ?? []).map(reachOf)),
    robots: (shown?.robots ?? []).map((r) => ({ side: r.side, unum: r.unum, type: r.type, position: [...r.poses.slice(0, 3)] })),
    ball: shown ? [...shown.ball.slice(0, 3)] : null,
    time: motion.frame?.time ?? null,
    mode: hud.game.mode ?? null,
    score: hud.game.left ? [hud.game.left.score, hud.game.right.score] : null,
    clock: hud.game.clock, replay: hud.replay,
    drawings: drawings.count, texts: drawings.texts.children.length,
    fps: stage.fps,
  }),
  // Where a place of the field is on the screen [px].
  screen(x, y, z = 0) {
    const v = new THREE.Vector3(x, y, z).project(stage.camera);
    return [((v.x + 1) / 2) * window.innerWidth, ((1 - v.y) / 2) * window.innerHeight];
  },
  look: (from, to) => cameras.look(from, to),
};
