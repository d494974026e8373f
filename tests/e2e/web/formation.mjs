// The formation edited in the page of an agent: node formation.mjs ADDRESS FORMATION-FILE PICTURE
import { appendFileSync, readFileSync } from 'node:fs';
import { Browser } from './browser.mjs';
import { check, giveUp, near, until } from './check.mjs';

const [address, path, picture] = process.argv.slice(2);
const text = () => readFileSync(path, 'utf8');
const browser = await Browser.open(`${address}?quality=low&fps=2#formation=open`, { width: 1600, height: 1000 });
const run = (expression) => browser.run(expression);
const state = () => run('document.getElementById("coachState").textContent');
const click = (id) => run(`document.getElementById("${id}").click()`);
const thing = (key) => `document.querySelector('#coachField g[data-thing="${key}"]')`;
const at = (key) => run(`plumbline.coach.pitch.things.get("${key}").at`);
const pixels = (key) => run(`(() => { const b = ${thing(key)}.querySelector('circle').getBoundingClientRect(); return [b.x + b.width / 2, b.y + b.height / 2]; })()`);
// By the mouse, to a place of the field.
async function drag(key, to) {
  const there = await run(`(() => { const p = new DOMPoint(${to[0]}, ${-to[1]}).matrixTransform(plumbline.coach.pitch.svg.getScreenCTM()); return [p.x, p.y]; })()`);
  await browser.drag(await pixels(key), there);
}
const linesThatDiffer = (a, b) => a.split('\n').filter((line, i) => line !== b.split('\n')[i]).length;

try {
  await until('the address opens the formation', () => run('Boolean(window.plumbline?.coach.isOpen && plumbline.coach.model && plumbline.coach.pitch?.things.size > 1)'));
  const names = [...text().matchAll(/- name: (\w+)/g)].map(([, name]) => name);
  check((await run('plumbline.coach.pitch.things.size')) === names.length + 1, 'the ball and each place are on the field');

  await drag('ball', [3.2, 4.8]);
  check(near(await at('ball'), [3, 5], 1e-6), 'a ball that is dropped near one of the table is there');
  const support = names.indexOf('leftSupport'), before = text(), was = await at(support);
  await drag(support, [was[0] + 2, was[1] - 1]);
  const put = await at(support);
  check(near(put, [was[0] + 2, was[1] - 1], 0.15), 'a place is dragged');
  check(/not saved/.test(await state()) && text() === before, 'which is not yet in the file');
  await click('coachUndo');
  check(near(await at(support), was, 1e-6) && !/not saved/.test(await state()), 'a drag is one step of undo');
  await click('coachRedo');

  await click('coachSave');
  await until('it is saved, and the player has read the file', async () => /saved, and the player has it/.test(await state()));
  check(linesThatDiffer(text(), before) === 2, 'a line of x and a line of y are other ones, all comments stay');
  const saved = (await run('plumbline.link.ask("get formation")'))[0].value;
  check(near([saved.places[support].x[1][3], saved.places[support].y[1][3]], put, 1e-6), 'as it was put');

  await drag('ball', [3, -5]);
  const mirror = names.indexOf('rightSupport');
  check(near(await at(mirror), [put[0], -put[1]], 1e-6), 'for a ball on the right left and right change sides');

  await run(`${thing(mirror)}.focus()`);
  for (const type of ['keyDown', 'keyUp']) await browser.call('Input.dispatchKeyEvent', { type, key: 'ArrowRight', code: 'ArrowRight' });
  check(near(await at(mirror), [put[0] + 0.1, -put[1]], 1e-6), 'the arrow keys move a place');
  await browser.screenshot(picture);

  appendFileSync(path, '# theirs\n');
  const theirs = text();
  await click('coachSave');
  await until('a file that was changed meanwhile is not overwritten', async () => /somebody else has changed the file/.test(await state()));
  check(text() === theirs, 'theirs is there');
  await click('coachDiscard');
  await until('discarded, the page shows theirs', async () => near(await at(mirror), [put[0], -put[1]], 1e-6) && /^as in/.test(await state()));

  await run(`plumbline.link.ask('set formation {"x" "no" "" {} {} {}}').catch((error) => { window.refusal = error.message; })`);
  await until('what is no formation is refused in words', () => run('/changed by somebody else|other places/.test(window.refusal ?? "")'));
  await click('toModules');
  check(!(await run('plumbline.coach.isOpen')), 'and one goes back to the modules');
  const problems = browser.problems.filter((line) => !/WebSocket|ERR_CONNECTION|beforeunload/.test(line));
  check(problems.length === 0, `no errors on the page ${problems.join('; ')}`);
  await browser.close();
  process.exit(0);
} catch (error) {
  await giveUp(browser, error, state, 'build/e2e/formation-failed.png');
}
