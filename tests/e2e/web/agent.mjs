// The page of a running agent: node agent.mjs ADDRESS DRAWINGPORT AGENTPID PICTURE
import dgram from 'node:dgram';
import { readFileSync } from 'node:fs';
import { Browser } from './browser.mjs';
import { check, giveUp, until } from './check.mjs';

const [address, drawingPort, agentPid, picture] = process.argv.slice(2);
const viewer = dgram.createSocket('udp4'), datagrams = [];
viewer.on('message', (bytes) => datagrams.push(bytes.toString('latin1')));
await new Promise((resolve) => viewer.bind(Number(drawingPort), '127.0.0.1', resolve));

const browser = await Browser.open(`${address}?quality=low&fps=4`, { width: 1600, height: 1000 });
const state = () => browser.run('window.plumbline?.state()');
const ask = (command) => browser.run(`plumbline.link.ask(${JSON.stringify(command)})`);
const value = async (name) => (await ask(`get ${name}`))[0].value;
const clickOn = (expression) => browser.run(`${expression}.click()`);
const panel = (name, kind = '') => `document.querySelector('.panel${kind}[data-name="${name}"]')`;

try {
  await until('the page shows the modules', async () => (await state())?.modules > 25);
  await until('the graph is connected', async () => (await state()).edges > 50);
  await until('the field is there', async () => (await state()).ground);
  check(await browser.run('[...document.querySelectorAll(".module")].some((m) => m.dataset.module === "BallLocator" && /LocalBallPos/.test(m.textContent))'), 'a module says what it provides');

  // A value as text, as plot, on the field.
  await clickOn('[...document.querySelectorAll(".module a")].find((a) => a.textContent === "BallPos")');
  await until('a representation is shown', async () => /relative/.test(await browser.run(`${panel('representation:BallPos')}?.textContent`)));
  await clickOn(`[...${panel('representation:BallPos')}.querySelectorAll('.row')].find((r) => r.firstChild?.textContent === 'field').querySelector('.act')`);
  await clickOn(`[...${panel('representation:BallPos')}.querySelectorAll('.row')].find((r) => r.firstChild?.textContent === 'x').querySelector('.act')`);
  await until('a part is plotted', () => browser.run(`Boolean(${panel('representation:BallPos.field.x', '.plot')}?.querySelector('canvas'))`));
  await until('its place is on the field', async () => (await state()).shapes >= 3);

  // Values are set, and let go.
  await browser.run(`(() => {
    const panel = ${panel('representation:BallPos')}, leaf = [...panel.querySelectorAll('.row')].filter((r) => r.firstChild?.textContent === 'x')[1].querySelector('.leaf');
    leaf.dispatchEvent(new MouseEvent('dblclick', { bubbles: true }));
    const input = panel.querySelector('.row input');
    input.value = '0.625';
    input.dispatchEvent(new KeyboardEvent('keydown', { key: 'Enter' }));
  })()`);
  await until('a value that is typed is set', async () => (await value('representation:BallPos.relative.x')) === 0.625);
  await clickOn(`[...${panel('representation:BallPos')}.querySelectorAll('header button')].find((b) => b.textContent === 'unset')`);
  await until('it is let go', async () => (await value('representation:BallPos.relative.x')) !== 0.625);

  // A parameter with its slider; what is out of range is refused in the agent's words.
  await browser.run("plumbline.panels.choose('config:BallLocator.viewAngle', 'parameter')");
  await until('a parameter has a slider over its range', () => browser.run(`${panel('config:BallLocator.viewAngle')}.querySelector('input[type="range"]')?.max === '1.5'`));
  await browser.run(`(() => {
    const slider = ${panel('config:BallLocator.viewAngle')}.querySelector('input[type="range"]');
    slider.value = 0.6;
    slider.dispatchEvent(new Event('input'));
  })()`);
  await until('the slider sets it', async () => (await value('config:BallLocator.viewAngle')) === 0.6);
  await browser.run(`(() => {
    const input = ${panel('config:BallLocator.viewAngle')}.querySelector('input[type="number"]');
    input.value = 7;
    input.dispatchEvent(new Event('change'));
  })()`);
  await until('a wrong value is refused', async () => /must be within \[0, 1.5\], not 7/.test(await browser.run('document.getElementById("message").textContent')));

  // Drawings here and in the viewer.
  for (const name of ['draw:FKModel:body', 'draw:RobotPose', 'draw:AugmentedSelfLocator:particles', 'draw:BallLocator:ball'])
    await clickOn(`document.querySelector('[data-drawing="${name}"]')`);
  await until('what modules draw is on the field', async () => (await state()).shapes > 40);
  check(datagrams.length === 0, 'a viewer hears nothing that it was not switched on for');
  await ask('dr draw:BallLocator:ball');
  await until('a drawing that is switched on reaches a viewer', () => datagrams.some((d) => d.startsWith('\x01') && d.endsWith('\0\0left.01.BallLocator:ball.\0')));
  await ask('dr draw:BallLocator:ball off');
  await until('the last datagram hides it', () => datagrams.at(-1) === '\0\0left.01.BallLocator:ball.\0');

  // Motions: one of the files, and a walk.
  await until('motions are offered', () => browser.run('Boolean(document.querySelector("[data-motion=wave]"))'));
  await clickOn('document.querySelector("[data-motion=wave]")');
  await until('the robot plays a motion', async () => (await value('representation:MotionSelection.specialAction')) === 'wave');
  await browser.run(`(() => {
    const slider = document.querySelector('#motionList .walk input');
    slider.value = 0.2;
    slider.dispatchEvent(new Event('input'));
  })()`);
  await until('it walks as the slider says', async () => (await value('representation:MotionSelection.motion')) === 'walk' && (await value('representation:MotionRequest.walkVelocity.x')) === 0.2);
  for (const name of ['draw:WalkingEngine:walk', 'draw:WalkingEngine:steps'])
    await until(`${name} is offered`, () => browser.run(`(() => { const box = document.querySelector('[data-drawing="${name}"]'); box?.click(); return Boolean(box); })()`));
  await until('planned steps are drawn', async () => (await ask('get draw:WalkingEngine:steps'))[0].value.length > 20);
  await clickOn('[...document.querySelectorAll("#motionList button")].find((b) => b.textContent === "hand back")');

  // The address keeps the page's contents.
  const before = (await state()).panels;
  await browser.screenshot(picture);
  await browser.call('Page.reload');
  await until('after a reload the same stands there', async () => JSON.stringify((await state())?.panels) === JSON.stringify(before));
  await until('and drawings go on', async () => { const now = await state(); return now?.drawings.length === 6 && now.shapes > 40; });

  // Looks, not seconds: on a busy machine they wait as the agent does.
  let looks = 0;
  process.kill(Number(agentPid), 'SIGINT');
  const ended = () => { ++looks; try { return /^\d+ \(.*\) Z/.test(readFileSync(`/proc/${agentPid}/stat`, 'utf8')); } catch { return true; } };
  await until('the agent ends', ended);
  check(looks <= 11, `an agent with a page ends within ten looks of a tenth of a second: ${looks - 1}`);
  await until('the page says so', async () => !(await state()).online);
  const problems = browser.problems.filter((text) => !/WebSocket|ERR_CONNECTION/.test(text));
  check(problems.length === 0, `no errors on the page ${problems.join('; ')}`);
  await browser.close();
  process.exit(0);
} catch (error) {
  await giveUp(browser, error, state, 'build/e2e/agent-failed.png');
}
