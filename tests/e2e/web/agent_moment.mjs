// Not a test: a picture of an agent's page while the robot goes to the ball.
//   node agent_moment.mjs ADDRESS FILE WHAT-IS-SHOWN [SHAPES [MODULE [TEXT]]]     so many shapes are drawn [150]; this
//   module is looked at [BallLocator]; the page shows this text
import { Browser } from './browser.mjs';
import { giveUp, until } from './check.mjs';

const [address, file, shown, shapes = 150, module = 'BallLocator', text = ''] = process.argv.slice(2);
const browser = await Browser.open(`${address}?fps=8#${shown}`, { width: 1600, height: 1000 });
const state = () => browser.run('window.plumbline?.state()');
try {
  await until('the page is there', async () => (await state())?.ground);
  await browser.run('plumbline.link.ask("set representation:GameState.playMode 3")'); // the game goes on
  await until('the robot walks', async () => (await browser.run('plumbline.link.ask("get representation:MotionSelection.motion")'))[0].value === 'walk');
  await until('all is drawn', async () => (await state()).shapes >= Number(shapes));
  await new Promise((resolve) => setTimeout(resolve, 9000));
  await browser.run(`document.querySelector("[data-module=${module}]").dispatchEvent(new MouseEvent("mouseenter"))`);
  await new Promise((resolve) => setTimeout(resolve, 1000));
  await until(`the page shows '${text}'`, () => browser.run(`document.body.innerText.includes(${JSON.stringify(text)})`));
  await browser.screenshot(file, file.endsWith('.jpg') ? 'jpeg' : 'png');
  await browser.close();
  process.exit(0);
} catch (error) {
  await giveUp(browser, error, state, 'build/e2e/agent_moment-failed.png');
}
