// The summary of a game, and the moment in 3D that it leads to: node summary.mjs PAGE REPLAY PICTURE
import { Browser } from './browser.mjs';
import { check, giveUp, until } from './check.mjs';

const [page, replay, picture] = process.argv.slice(2);
const browser = await Browser.open(page, { width: 1280, height: 1500 });
const run = (expression) => browser.run(expression);
// Whether something is drawn on a canvas, not one colour all over.
const drawn = (selector) => run(`(() => { const c = document.querySelector('${selector}'), d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data; const seen = new Set(); for (let i = 0; i < d.length; i += 400) seen.add(d[i] * 65536 + d[i + 1] * 256 + d[i + 2]); return seen.size; })()`);

try {
  await until('the page shows a game', () => run('Boolean(window.plumbline?.result)'));
  check((await run('plumbline.game.robots.length')) === 4, 'with four players');
  check(/^\d+ : \d+$/.test(await run('document.querySelector("#result .score").textContent')), 'the score');
  check((await run('document.querySelectorAll("#figures tr").length')) === 11, 'the figures');
  check((await drawn('#field')) > 3, 'a moment');
  for (const map of ['#heat figure:nth-child(1) canvas', '#heat figure:nth-child(2) canvas', '#ways canvas']) check((await drawn(map)) > 2, `a map ${map}`);
  check((await run('plumbline.result.figures.left.way > 1 && plumbline.result.figures.right.way > 1')), 'the players have gone some way');

  const [x, y, width] = await run('(() => { const b = document.getElementById("line").getBoundingClientRect(); return [b.x, b.y + b.height / 2, b.width]; })()');
  await browser.mouse('mousePressed', x + width / 2, y);
  await browser.mouse('mouseReleased', x + width / 2, y);
  const middle = await run('(plumbline.game.times[0] + plumbline.game.times.at(-1)) / 2');
  await until('the time line goes to a time', async () => Math.abs((await run('plumbline.time()')) - middle) < 0.5);
  check((await run('document.getElementById("in3d").href')).endsWith(`#t=${(await run('plumbline.time()')).toFixed(1)}`), 'the link in 3D leads there');

  // A decision in the middle of them all, and the moment of it on the time line.
  const decision = await run(`(() => {
    const { side, unum, lines } = plumbline.decisions[0], line = lines[Math.floor(lines.length / 2)];
    const i = plumbline.game.clock.findIndex((clock) => clock >= line[0] + 0.05);
    return { side, unum, line, share: (plumbline.game.times[i] - plumbline.game.times[0]) / (plumbline.game.times.at(-1) - plumbline.game.times[0]) };
  })()`);
  await browser.mouse('mousePressed', x + decision.share * width, y);
  await browser.mouse('mouseReleased', x + decision.share * width, y);
  const rows = (kind) => run(`[...document.querySelectorAll('#decisions .${kind}')].map((row) => [...row.cells].map((cell) => cell.textContent))`);
  await until('a click shows a decision', async () => (await rows('chosen')).length > 0);
  check((await run('document.querySelector("#decisions caption").textContent')).startsWith(`Number ${decision.unum} of `), 'of this player');
  const [chosen] = await rows('chosen');
  check(decision.line[3].some(([action]) => action === chosen[0]) && /^-?\d\.\d{3}$/.test(chosen[2]) && /^\d+ %$/.test(chosen[3]), `with its action, value and goal: ${chosen}`);
  check((await rows('rejected')).length >= 1, 'and what it decided against');
  await browser.screenshot(picture);
  check(browser.problems.length === 0, `no errors on the page ${browser.problems.join('; ')}`);

  await browser.call('Page.navigate', { url: `${replay}?quality=low&fps=2#t=${middle.toFixed(1)}` });
  const at = async () => { try { return (await run('window.plumbline?.state().replay?.time')) ?? -1; } catch { return -1; } };
  await until('the replay in 3D begins there', async () => (await at()) >= middle - 1);
  await browser.close();
  process.exit(0);
} catch (error) {
  await giveUp(browser, error, () => browser.run('window.plumbline?.state?.()'), 'build/e2e/summary-failed.png');
}
