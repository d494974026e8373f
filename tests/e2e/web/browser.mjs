// Drives a headless Chromium over its debugging pipe: nothing but Node.js is needed, whatever the browser's version.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const flags = ['--headless', '--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
  '--disable-component-update', '--disable-sync', '--disable-extensions', '--mute-audio', '--hide-scrollbars',
  '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-dev-shm-usage',
  '--remote-debugging-pipe'];

export class Browser {
  static async open(url, { width = 1280, height = 720 } = {}) {
    const browser = new Browser();
    browser.profile = mkdtempSync(join(tmpdir(), 'chromium-'));
    browser.process = spawn(process.env.CHROMIUM ?? 'chromium',
      [...flags, `--user-data-dir=${browser.profile}`, `--window-size=${width},${height}`, 'about:blank'],
      { stdio: ['ignore', 'ignore', 'ignore', 'pipe', 'pipe'], detached: true });
    browser.process.on('error', (error) => { throw new Error(`cannot start chromium: ${error.message}`); });
    browser.waiting = new Map();
    browser.problems = [];
    browser.next = 1;
    let text = '';
    browser.process.stdio[4].on('data', (bytes) => {
      text += bytes;
      const messages = text.split('\0');
      text = messages.pop();
      for (const message of messages) browser.take(JSON.parse(message));
    });
    const { targetInfos } = await browser.call('Target.getTargets', {}, null);
    const { targetId } = targetInfos.find((t) => t.type === 'page') ?? await browser.call('Target.createTarget', { url: 'about:blank' }, null);
    browser.session = (await browser.call('Target.attachToTarget', { targetId, flatten: true }, null)).sessionId;
    for (const domain of ['Page', 'Runtime', 'Log']) await browser.call(`${domain}.enable`);
    await browser.call('Emulation.setDeviceMetricsOverride', { width, height, deviceScaleFactor: 1, mobile: false });
    await browser.call('Page.navigate', { url });
    return browser;
  }

  take(message) {
    if (message.id) {
      const { resolve, reject } = this.waiting.get(message.id);
      this.waiting.delete(message.id);
      if (message.error) reject(new Error(message.error.message));
      else resolve(message.result);
    } else if (message.method === 'Runtime.exceptionThrown') {
      this.problems.push(message.params.exceptionDetails.exception?.description ?? message.params.exceptionDetails.text);
    } else if (message.method === 'Log.entryAdded' && message.params.entry.level === 'error') {
      this.problems.push(`${message.params.entry.text} ${message.params.entry.url ?? ''}`);
    } else if (message.method === 'Runtime.consoleAPICalled' && message.params.type === 'error') {
      this.problems.push(message.params.args.map((a) => a.value ?? a.description).join(' '));
    }
  }

  call(method, params = {}, sessionId = this.session) {
    return new Promise((resolve, reject) => {
      const id = this.next++;
      this.waiting.set(id, { resolve, reject });
      this.process.stdio[3].write(`${JSON.stringify({ id, method, params, ...(sessionId ? { sessionId } : {}) })}\0`);
    });
  }

  async run(expression) {
    const { result, exceptionDetails } = await this.call('Runtime.evaluate', { expression, returnByValue: true, awaitPromise: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  async mouse(type, x, y, more = {}) {
    await this.call('Input.dispatchMouseEvent', { type, x, y, button: 'left', buttons: type === 'mouseReleased' ? 0 : 1, clickCount: 1, ...more });
  }

  async drag([x1, y1], [x2, y2], steps = 8) {
    await this.mouse('mouseMoved', x1, y1, { button: 'none', buttons: 0 });
    await this.mouse('mousePressed', x1, y1);
    for (let i = 1; i <= steps; ++i) await this.mouse('mouseMoved', x1 + ((x2 - x1) * i) / steps, y1 + ((y2 - y1) * i) / steps);
    await this.mouse('mouseReleased', x2, y2);
  }

  async click(selector) {
    const [x, y] = await this.run(`(() => { const b = document.querySelector(${JSON.stringify(selector)}).getBoundingClientRect(); return [b.x + b.width / 2, b.y + b.height / 2]; })()`);
    await this.mouse('mousePressed', x, y);
    await this.mouse('mouseReleased', x, y);
  }

  async screenshot(file, format = 'png') {
    const { data } = await this.call('Page.captureScreenshot', { format });
    writeFileSync(file, Buffer.from(data, 'base64'));
  }

  async close() {
    const ended = new Promise((resolve) => this.process.on('exit', resolve));
    this.call('Browser.close', {}, null).catch(() => {});
    const timer = setTimeout(() => { try { process.kill(-this.process.pid, 'SIGKILL'); } catch { /* it has ended */ } }, 5000);
    await ended;
    clearTimeout(timer);
    rmSync(this.profile, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
  }
}
