// A recorded match on the page: it plays, stops, and shows any time of it.
import { Browser } from './browser.mjs';
import { check, giveUp, near, until } from './check.mjs';
import { clocks } from './layout.mjs';

const browser = await Browser.open(`${process.argv[2]}?quality=low&fps=4`, { width: 960, height: 600 });
const state = () => browser.run('window.plumbline?.state()');
try {
  await until('the recording is shown', async () => (await state())?.replay?.duration > 5);
  const { duration } = (await state()).replay;
  await until('it plays', async () => (await state()).replay.time > 0.5);
  const slider = (time) => browser.run(`(() => { const s = document.getElementById('replayTime'); s.value = ${time}; s.dispatchEvent(new Event('input')); })()`);
  await slider(duration);
  await until('the end has 22 robots and the ball in the middle', async () => {
    const now = await state();
    return now.robots.length === 22 && near(now.ball, [0, 0, 0.042], 0.05) && !now.replay.playing;
  });
  const time = async () => (await state()).replay.time;
  const nearTime = (wanted) => async () => Math.abs(await time() - wanted) < 0.05;
  const press = async (key, code) => { for (const type of ['keyDown', 'keyUp']) await browser.call('Input.dispatchKeyEvent', { type, key, code }); };
  const back = Math.max(0, duration - 5);
  await browser.click('[data-skip="-5"]');
  await until('five seconds back by the button', nearTime(back));
  await press(',', 'Comma');
  await until('one picture back by the comma', nearTime(Math.max(0, back - 0.04)));
  await press('ArrowRight', 'ArrowRight');
  await until('five seconds on by the arrow', nearTime(Math.min(duration, Math.max(0, back - 0.04) + 5)));
  await slider(0);
  await until('the begin has none', async () => (await state()).robots.length < 22);
  await browser.click('#replayPlay');
  await until('it plays again', async () => (await state()).replay.playing);
  check(await browser.run("document.getElementById('trainer').hidden"), 'a recording takes no trainer commands');
  const shown = await clocks(browser);
  check(Object.keys(shown).join() === 'clock,replayClock' && /^\d+:\d\d\.\d$/.test(shown.clock) && shown.replayClock.startsWith('recording '),
    `the clock of the match, and one that says that it is the recording's: ${JSON.stringify(shown)}`);
  check(browser.problems.length === 0, `no errors on the page: ${browser.problems.join('; ')}`);
  await browser.close();
} catch (error) {
  await giveUp(browser, error, state, 'build/e2e/replay-failed.png');
}
