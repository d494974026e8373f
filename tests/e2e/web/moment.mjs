// Not a test: a picture of a recorded match at a time of the game.
//   node tests/e2e/web/moment.mjs URL FILE GAME_SECONDS [X,Y,Z]     from where it looks at the ball, relative to the ball [m]
import { Browser } from './browser.mjs';
import { giveUp, until } from './check.mjs';

const [url, file, wanted, eye = '-2.5,-8.5,4'] = process.argv.slice(2);
const browser = await Browser.open(`${url}?quality=high&fps=2`, { width: 1280, height: 720 });
const state = () => browser.run('window.plumbline?.state()');
const wait = (ms) => new Promise((r) => setTimeout(r, ms));
try {
  await until('the recording is there', async () => (await state())?.replay?.duration > 1);
  await browser.click('#replayPlay');
  await until('it stands', async () => !(await state()).replay.playing);
  // The recording's time is that of the clock on the wall; the game's is found by halving.
  let [low, high] = [0, (await state()).replay.duration];
  for (let i = 0; i < 14; ++i) {
    const middle = (low + high) / 2;
    await browser.run(`(() => { const s = document.getElementById('replayTime'); s.value = ${middle}; s.dispatchEvent(new Event('input')); })()`);
    await until('it is there', async () => Math.abs((await state()).replay.time - middle) < 0.05);
    await wait(300);
    if ((await state()).time < Number(wanted)) low = middle;
    else high = middle;
  }
  await wait(2500);
  const { ball: [x, y] } = await state();
  const [dx, dy, z] = eye.split(',').map(Number);
  await browser.run(`window.plumbline.look([${x + dx}, ${y + dy}, ${z}], [${x}, ${y}, 0.2])`);
  await wait(3000);
  await browser.screenshot(file, file.endsWith('.jpg') ? 'jpeg' : 'png');
  await browser.close();
} catch (error) {
  await giveUp(browser, error, state, 'build/e2e/moment-failed.png');
}
