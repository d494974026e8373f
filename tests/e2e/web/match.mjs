// A running game on the page; web.sh starts what it needs.
import { Browser } from './browser.mjs';
import { check, giveUp, near, until } from './check.mjs';
import * as draw from './drawings.mjs';
import { Trainer, twoTeams } from './simspark.mjs';

const [url, otherUrl, agentPort, monitorPort, drawingPort, simulator, picture] = process.argv.slice(2);

const page = (address) => `${address}?quality=low&fps=4`;

async function open(address) {
  const browser = await Browser.open(page(address), { width: 960, height: 600 });
  await until('the page is there', () => browser.run('Boolean(window.plumbline?.state().online)'));
  browser.state = () => browser.run('window.plumbline.state()');
  return browser;
}

async function main(browser, trainer) {
  const { state } = browser;
  await twoTeams(Number(agentPort));
  await until('22 robots with all their bodies', async () => {
    const { robots, bodies } = await state();
    return robots.length === 22 && bodies === 514; // 4 of the 22 are of type 4 and have toes
  });
  const names = (await state()).robots.map((r) => `${r.side} ${r.unum}`);
  check(new Set(names).size === 22, 'each robot once');
  check(new Set((await state()).robots.map((r) => r.type)).size === 5, 'all types');
  const sent = await trainer.torsos();
  check(sent.length === 22, 'the monitor port tells of 22 robots');
  await until('they stand where the monitor port says', async () => {
    const shown = (await state()).robots;
    return sent.every((t) => shown.some((s) => s.side === t.side && s.unum === t.unum && s.type === t.type && near(s.position, t.position, 0.02)));
  });
  await browser.screenshot(picture);

  // Buttons of the page; then a trainer elsewhere moves the ball.
  await browser.click('[data-do=kickOffLeft]');
  await until('kick-off by the button', async () => (await state()).mode === 'KickOff_Left');
  await browser.click('[data-do=playOn]');
  await until('play on by the button', async () => (await state()).mode === 'PlayOn');
  await until('the clock goes', async () => (await state()).time > 0.5);
  trainer.send('(ball (pos 0 3 0.042)(vel 3 0 0))');
  await until('the ball rolls', async () => (await state()).ball[0] > 0.3 && near((await state()).ball, [1.5, 3, 0.042], 1.3));

  // Pause, step, speed.
  await browser.click('[data-do=pause]');
  await until('paused', async () => (await state()).clock?.paused === true);
  await new Promise((r) => setTimeout(r, 500));
  const before = (await state()).time;
  await browser.click('[data-do=step]');
  await until('one step is one cycle', async () => Math.abs((await state()).time - before - 0.02) < 0.005);
  await browser.click('[data-do=pause]');
  await until('goes on', async () => (await state()).time > before + 0.2);

  // With the mouse: a robot, then the ball.
  await browser.run('window.plumbline.look([-6, -9, 7], [-6, 0, 0])');
  await new Promise((r) => setTimeout(r, 500));
  const robot = (await state()).robots.find((r) => r.side === 'left' && r.unum === 8);
  const screen = (x, y, z) => browser.run(`window.plumbline.screen(${x}, ${y}, ${z})`);
  const target = [-7.5, -3.2];
  await browser.drag(await screen(...robot.position), await screen(...target, robot.position[2]));
  await until('dragging beams the robot: the monitor port says so', async () => {
    const now = (await trainer.torsos()).find((r) => r.side === 'left' && r.unum === 8);
    return near(now.position.slice(0, 2), target, 0.25);
  });
  await until('and the page shows it', async () => {
    const now = (await state()).robots.find((r) => r.side === 'left' && r.unum === 8);
    return near(now.position.slice(0, 2), target, 0.25);
  });
  trainer.send('(ball (pos -5 2 0.042)(vel 0 0 0))');
  await until('the ball lies in view', async () => near((await state()).ball, [-5, 2, 0.042], 0.05));
  await browser.drag(await screen(-5, 2, 0.042), await screen(-7, -2, 0.042));
  await until('dragging moves the ball', async () => near((await state()).ball, [-7, -2, 0.042], 0.2));

  await browser.click('[data-do=reset]');
  await until('reset', async () => {
    const now = await state();
    return now.mode === 'BeforeKickOff' && near(now.ball, [0, 0, 0.042], 0.05) && now.time < 1;
  });
  check(browser.problems.length === 0, `no errors on the page: ${browser.problems.join('; ')}`);
}

async function drawings(browser) {
  const { state } = browser;
  await until('the other monitor shows the same', async () => (await state()).robots.length === 22);
  const port = Number(drawingPort);
  await draw.send(port, [
    draw.line([-2, 1, 0], [0, 0, 0], 3, [255, 220, 0], 'l_1.path'),
    Buffer.concat([draw.circle(1, 2, 0.5, 2, [0, 255, 255], 'l_1.ring'), draw.point([1, 1, 0], 8, [255, 0, 0], 'l_1.dot')]),
    draw.sphere([3, 3, 0.5], 0.15, [255, 0, 255], 'l_1.ball'),
    draw.polygon([[-15, -3, 0], [-13, -3, 0], [-13, 3, 0]], [255, 160, 0, 90], 'l_1.area'),
    draw.annotation([0, 4, 0.5], [255, 255, 255], 'kick', 'l_10.text'),
    draw.agentText('left', 10, [255, 255, 120], 'support'),
  ]);
  await until('texts of agents are shown at once', async () => (await state()).texts === 1);
  check((await state()).drawings === 0, 'shapes wait for their swap');
  await draw.send(port, [draw.swap('l_1')]);
  await until('six shapes in five sets and the one whose name begins so', async () => (await state()).drawings === 6);
  await draw.send(port, [draw.swap('')]);
  await until('the next swap takes them away', async () => (await state()).drawings === 0);
  check(browser.problems.length === 0, `no errors on the page: ${browser.problems.join('; ')}`);
}

let browser;
try {
  const trainer = await Trainer.open(Number(monitorPort));
  browser = await open(url);
  await main(browser, trainer);
  await browser.call('Page.navigate', { url: page(otherUrl) });
  await until('the other page is there', () => browser.run(`location.href.startsWith('${otherUrl}') && Boolean(window.plumbline?.state().online)`));
  await drawings(browser);
  // While the robots are still there, or the recording may end with an empty field.
  const ended = new Promise((resolve) => { trainer.socket.once('close', resolve); });
  process.kill(Number(simulator), 'SIGTERM');
  await ended;
  await browser.close();
  process.exit(0);
} catch (error) {
  await giveUp(browser, error, () => browser.run('window.plumbline?.state()'), 'build/e2e/web-failed.png');
}
