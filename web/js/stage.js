// Renderer, light, sky, and how much of it this machine can do.
import * as THREE from '../three/three.module.js';
import { haze, makeSky } from './sky.js';

export class Stage {
  constructor(canvas) {
    THREE.Object3D.DEFAULT_UP.set(0, 0, 1);
    this.quality = new URLSearchParams(location.search).get('quality');
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: this.quality !== 'low', powerPreference: 'high-performance' });
    this.renderer.shadowMap.enabled = this.quality !== 'low';
    this.renderer.shadowMap.type = THREE.PCFShadowMap;
    this.renderer.toneMapping = THREE.ACESFilmicToneMapping;
    this.renderer.toneMappingExposure = 1.05;
    this.scene = new THREE.Scene();
    this.scene.background = new THREE.Color(haze);
    this.scene.fog = new THREE.Fog(haze, 40, 190);
    this.camera = new THREE.PerspectiveCamera(42, 1, 0.05, 250);
    this.camera.up.set(0, 0, 1);
    this.scene.add(makeSky());
    this.addLight();
    this.ratio = Math.min(window.devicePixelRatio, 2) * (this.quality === 'low' ? 0.7 : 1);
    this.slow = { frames: 0, since: performance.now(), steps: 0 };
    this.fps = 0;
    window.addEventListener('resize', () => this.resize());
    this.resize();
  }

  addLight() {
    this.scene.add(new THREE.HemisphereLight(0xe6f0f7, 0x56705a, 1.25));
    const sun = new THREE.DirectionalLight(0xfff1dd, 2.5);
    sun.position.set(-14, -12, 26);
    sun.castShadow = true;
    sun.shadow.mapSize.set(2048, 2048);
    sun.shadow.radius = 2.5;
    Object.assign(sun.shadow.camera, { near: 5, far: 70 });
    sun.shadow.bias = -0.0004;
    sun.shadow.normalBias = 0.015;
    this.sun = sun;
    this.scene.add(sun, sun.target);
  }

  // Shadows are sharp where one looks: the part of the field around a place is in the shadow map.
  light(target, distance) {
    const reach = Math.min(21, Math.max(3, distance * 0.9));
    const camera = this.sun.shadow.camera;
    const x = Math.abs(reach - 21) < 0.1 ? 0 : target.x, y = Math.abs(reach - 21) < 0.1 ? 0 : target.y;
    this.sun.target.position.set(x, y, 0);
    this.sun.position.set(x - 14, y - 12, 26);
    if (Math.abs(camera.right - reach) > 0.3) {
      Object.assign(camera, { left: -reach, right: reach, top: reach, bottom: -reach });
      camera.updateProjectionMatrix();
    }
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.renderer.domElement;
    if (!width || !height) return;
    this.renderer.setPixelRatio(this.ratio);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.scene.userData.resolution = [width, height];
  }

  // A machine that cannot keep up gets fewer pixels, then no shadows.
  adapt(now) {
    if (++this.slow.frames < 40) return;
    this.fps = (1000 * this.slow.frames) / (now - this.slow.since);
    this.slow = { frames: 0, since: now, steps: this.slow.steps };
    if (this.fps > 22 || this.quality || this.slow.steps >= 3 || document.hidden) return;
    const step = this.slow.steps++;
    if (step === 1) {
      this.renderer.shadowMap.enabled = false;
      this.sun.castShadow = false;
      this.scene.traverse((o) => { if (o.material) o.material.needsUpdate = true; });
    } else {
      this.ratio = Math.max(0.7, this.ratio * 0.75);
      this.resize();
    }
  }

  render(now) {
    this.renderer.render(this.scene, this.camera);
    this.adapt(now);
  }
}
