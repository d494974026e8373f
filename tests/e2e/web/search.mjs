// The page of a search: node search.mjs ADDRESS live|shown PICTURE
import { Browser } from './browser.mjs';
import { check, giveUp, until } from './check.mjs';

const [address, how, picture] = process.argv.slice(2);
const browser = await Browser.open(`${address}?quality=low&fps=2`, { width: 1600, height: 1000 });
const run = (expression) => browser.run(expression);
const state = () => run('window.plumbline?.state()');
const text = (id) => run(`document.getElementById("${id}").textContent`);

try {
  await until('the page knows what is searched', async () => (await state())?.study?.task === 'standUp');
  check(/front.*cmaes, seed 1/.test(await text('options')), 'and says how');
  const { parameters } = (await state()).study;
  check((await state()).parameters === parameters.length && parameters.length > 50, `all ${parameters.length} parameters have a row`);
  if (how === 'live') {
    await until('it is over when all generations are done', async () => /over: maxGenerations/.test(await text('state')), 600);
    check(/8 \/ 8/.test(await text('numbers')), 'the figures say so');
  } else {
    await until('a folder alone is shown', async () => /over: maxGenerations/.test(await text('state')));
    check(/does not run/.test(await text('workers')), 'without workers');
  }
  await until('a point for each generation', async () => (await state()).points === 8);
  check((await run('document.querySelectorAll("#costs canvas, #sigma canvas").length')) === 2, 'in two plots');
  check(!(await run('document.querySelector(".parameter:not(.head) b").textContent')).includes('-'.repeat(2)), 'parameters have values');
  await until('start and found are played', async () => (await state()).film.films.sort().join() === 'found,start');
  check((await state()).film.seconds > 2, 'with the walk behind it');
  await until('it moves', async () => { const { time } = (await state()).film; await new Promise((r) => setTimeout(r, 600)); return (await state()).film.time !== time; });
  await run('document.getElementById("moved").click()');
  const change = 'Math.abs(Number(document.querySelectorAll(".parameter .reach i")[INDEX].style.width.replace("%", "")))';
  check((await run(change.replace('INDEX', 0))) >= (await run(change.replace('INDEX', 5))), 'the most changed come first');
  await run('(() => { const f = document.getElementById("filter"); f.value = "knee"; f.dispatchEvent(new Event("input")); })()');
  check((await run('[...document.querySelectorAll(".parameter:not(.head)")].every((r) => /knee/i.test(r.dataset.parameter))')), 'parameters are found by name');
  await browser.screenshot(picture);
  const problems = browser.problems.filter((line) => !/WebSocket|ERR_CONNECTION/.test(line));
  check(problems.length === 0, `no errors on the page ${problems.join('; ')}`);
  await browser.close();
  process.exit(0);
} catch (error) {
  await giveUp(browser, error, state, 'build/e2e/search-failed.png');
}
