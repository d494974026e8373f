// A page in a browser that draws two pictures a second: no robot may come apart. It has one clock, and what it says is wrong
// lies over neither score nor buttons. node slow.mjs URL PICTURE
import { Browser } from './browser.mjs';
import { check, giveUp, until } from './check.mjs';
import { clocks, overlapped, resize } from './layout.mjs';

const [url, picture] = process.argv.slice(2);
const browser = await Browser.open('about:blank', { width: 960, height: 600 });
try {
  // A picture that takes half a second: its time is that of its start, messages wait until it is done.
  await browser.call('Page.addScriptToEvaluateOnNewDocument', { source: `
    const draw = window.requestAnimationFrame.bind(window);
    window.reaches = [];
    window.requestAnimationFrame = (picture) => draw((start) => {
      picture(start - 400);
      window.reaches.push(window.plumbline?.state().reach ?? 0);
      while (performance.now() < start + 500);
    });
    // A server that goes away, and is not there again.
    window.WebSocket = class extends WebSocket {
      constructor(url, protocol) {
        super(window.cut ? 'ws://localhost:1/' : url, protocol);
        window.socket = this;
      }
    };` });
  await browser.call('Page.navigate', { url: `${url}?quality=low&camera=ball` });
  await until('a robot is there and walks', async () => {
    const state = await browser.run('window.plumbline?.state()');
    return state?.robots.length === 1 && state.time > 4;
  });
  const begin = await browser.run('window.reaches.length');
  await until('25 more pictures', async () => await browser.run('window.reaches.length') >= begin + 25);
  await browser.screenshot(picture);
  const furthest = await browser.run('Math.max(...window.reaches)');
  check(furthest > 0.2 && furthest < 0.55, `no body is further than 0.55 m from its torso in any picture: ${furthest.toFixed(2)} m`);
  check(browser.problems.length === 0, `no errors on the page: ${browser.problems.join('; ')}`);
  const shown = await clocks(browser);
  check(Object.keys(shown).join() === 'clock' && /^0:\d\d\.\d$/.test(shown.clock), `one clock: ${JSON.stringify(shown)}`);
  await browser.run('window.cut = true; window.socket.close()');
  await until('the page says that the server is gone', async () =>
    (await browser.run("document.getElementById('problem').innerText")) === 'No connection to the server of this page; it connects again by itself');
  for (const [width, height] of [[1920, 1080], [960, 600], [600, 500], [390, 800]]) {
    await resize(browser, width, height);
    const over = await overlapped(browser, 'problem', ['board', 'trainer', 'cameras', 'info']);
    check(over.length === 0, `what is wrong lies over nothing else on ${width} by ${height} pixels: ${over}`);
  }
  await browser.close();
} catch (error) {
  await giveUp(browser, error, () => browser.run('window.plumbline?.state()'), 'build/e2e/slow-failed.png');
}
