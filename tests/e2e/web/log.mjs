// A log stepped through in the page of an agent: node log.mjs ADDRESS PICTURE
import { Browser } from './browser.mjs';
import { check, giveUp, until } from './check.mjs';

const [address, picture] = process.argv.slice(2);
const shown = '#text=representation:FrameInfo&plot=representation:BallPos.relative.x&draw=draw:FKModel:body&draw=draw:BallLocator:ball';
const browser = await Browser.open(`${address}?quality=low&fps=3${shown}`, { width: 1600, height: 1000 });
const run = (expression) => browser.run(expression);
const value = async (name) => (await run(`plumbline.link.ask("get ${name}")`))[0].value;
const click = (id) => run(`document.getElementById("${id}").click()`);
const type = (id, text, event) => run(`(() => { const input = document.getElementById("${id}"); input.value = ${text}; input.dispatchEvent(new Event("${event}")); })()`);
const cycle = () => value('replay:cycle');
// The text of the panel, which only watches.
const shownTime = () => run(`(() => { const row = [...document.querySelectorAll('.panel.text .row')].find((r) => r.firstChild?.textContent === 'time'); return Number(row?.querySelector('.leaf')?.textContent); })()`);
const near = (a, b) => Math.abs(a - b) < 0.011;

try {
  await until('an agent on a log has a bar', () => run('Boolean(document.getElementById("momentBar"))'));
  check((await value('replay:paused')) === true && (await cycle()) === 0, 'it waits before the first cycle');
  const { last, cycles } = await run('plumbline.moment.span');
  check(cycles > 380 && last > 7.5, `the slider goes over the log: ${cycles} cycles, ${last} s`);

  await type('momentTime', 4, 'change');
  await until('it goes to a time', async () => near(await value('replay:time'), 4) && near(await value('representation:FrameInfo.time'), 4));
  await until('the values follow', async () => near(await shownTime(), 4));
  await until('and the field', () => run('plumbline.state().shapes > 20'));
  await until('the plot has the log\'s time', () => run('near = plumbline.panels.open.find((p) => p.kind === "plot").panel.points.some(([t]) => Math.abs(t - plumbline.link.moment) < 1e-6)'));

  await until('it rests', async () => { await run('plumbline.moment.turn'); return true; });
  const there = await cycle(), ball = JSON.stringify(await value('representation:BallPos')), drawn = () => run('JSON.stringify(plumbline.field.sets.get("draw:BallLocator:ball"))');
  await until('what is drawn is of this cycle', async () => Boolean(await drawn()));
  const before = await drawn();
  await click('momentStep');
  await until('a cycle on', async () => (await cycle()) === there + 1);
  await until('the values are a cycle on', async () => near(await shownTime(), 4.02));
  await run('plumbline.moment.turn');
  await click('momentBack');
  await until('a cycle back', async () => (await cycle()) === there);
  await run('plumbline.moment.turn');
  check(JSON.stringify(await value('representation:BallPos')) === ball, 'the same as before, to the last digit');
  await until('on the field too', async () => (await drawn()) === before);

  await type('momentSlider', 2, 'input');
  await type('momentSlider', 2, 'change');
  await until('the slider goes to a time', async () => near(await shownTime(), 2));
  await until('what came behind is not in the plot any more', () => run('plumbline.panels.open.find((p) => p.kind === "plot").panel.points.every(([t]) => t < 2.1)'));

  await run('plumbline.moment.turn');
  const from = await cycle();
  await click('momentPlay');
  await until('it plays', async () => (await cycle()) > from + 10);
  await click('momentPlay');
  await until('and stops', async () => (await value('replay:paused')) === true);
  const stopped = await cycle();
  await new Promise((resolve) => setTimeout(resolve, 300));
  check((await cycle()) === stopped, 'where it was');
  await browser.screenshot(picture);
  await type('momentTime', 99, 'change');
  await until('beyond the end is the end', async () => (await cycle()) === cycles);
  const problems = browser.problems.filter((line) => !/WebSocket|ERR_CONNECTION/.test(line));
  check(problems.length === 0, `no errors on the page ${problems.join('; ')}`);
  await browser.close();
  process.exit(0);
} catch (error) {
  await giveUp(browser, error, () => browser.run('window.plumbline?.state?.()'), 'build/e2e/log-failed.png');
}
