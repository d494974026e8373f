// The report of the gap diagnosis, opened from disk in a browser: it says its verdict, draws its map and its curves,
// and asks nothing of a network.
//   report.mjs PAGE WORDS [PICTURE]   WORDS: the cause, as the verdict's sentence names it
import { pathToFileURL } from 'node:url';
import { Browser } from '../web/browser.mjs';
import { check, until } from '../web/check.mjs';

const [page, words, picture] = process.argv.slice(2);
const browser = await Browser.open(pathToFileURL(page).href, { width: 1240, height: 900 });
try {
  await until('the page is put together', () => browser.run("document.body?.dataset.ready === 'yes'"));
  const sentence = await browser.run("document.getElementById('sentence').textContent");
  check(sentence.startsWith(`Almost certainly ${words} (`) && /\((9\d|100)\u202f%\)\.$/.test(sentence), `the verdict is a sentence that says '${words}': '${sentence}'`);
  const short = await browser.run("document.getElementById('short').textContent");
  check(/^In short: the simulator lacks load friction at Elbow; with it in, about 9\d\u202f% of its error is expected to go\.$/.test(short), `the answer in a sentence: '${short}'`);
  // The same sentence of other answers.
  const inShort = (answer) => browser.run(`report.inShort(${JSON.stringify(answer)})`);
  const effects = [{ effect: 'load_friction', at: 'Elbow' }, { effect: 'backlash', at: 'Knee' }];
  for (const [answer, wanted] of [
    [{ verdict: 'none' }, 'In short: for these motions the simulator can be trusted as it is.'],
    [{ verdict: 'effect', effects, gap: { closed: 0.5 } },
      'In short: the simulator lacks load friction at Elbow and backlash at Knee; with them in, about 50\u202f% of its error is expected to go.'],
    [{ verdict: 'effect', effects: effects.slice(0, 1) }, 'In short: the simulator lacks load friction at Elbow; with it in, a part of its error is expected to go.'],
    [{ verdict: 'unknown', effects: effects.slice(1), gap: { closed: 0.25 } },
      'In short: the simulator is wrong in a way that we do not fully understand; what comes nearest, backlash at Knee, removes 25\u202f% of its error, so measure again before building on it.'],
    [{ verdict: 'unknown' }, 'In short: the simulator is wrong in a way that we do not understand; measure again before building on it.'],
  ]) {
    const said = await inShort(answer);
    check(said === wanted, `of ${answer.verdict}: '${said}'`);
  }
  const tooWide = "[...document.querySelectorAll('.tile b')].filter((b) => b.scrollWidth > b.clientWidth).map((b) => b.textContent)";
  check((await browser.run(tooWide)).length === 0, `numbers and names fit their tiles: ${await browser.run(tooWide)}`);
  const painted = await browser.run(`[...document.querySelectorAll('.uplot canvas')].map((canvas) => {
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    const colours = new Set();
    for (let i = 0; i < data.length; i += 4) if (data[i + 3] > 0) colours.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
    return colours.size;
  })`);
  check(painted.length >= 2, `there are curves: ${painted.length}`);
  check(painted.every((colours) => colours > 3), `all curves are drawn, colours ${painted.join(' ')}`);
  check(await browser.run("document.querySelectorAll('#map .cell').length") > 3, 'the map has cells');
  check(await browser.run("document.querySelectorAll('#gaps .before').length") > 1, 'there are bars for signals');
  check((await browser.run("document.getElementById('nextMotion').textContent")).length > 20, 'a next motion is suggested');
  check(await browser.run("performance.getEntriesByType('resource').length") === 0, 'nothing else is loaded');

  // Dragging over a curve zooms into it, a double click shows all again.
  await browser.run("document.querySelector('#overlays').scrollIntoView()");
  const range = () => browser.run('report.shown()');
  const [left, right] = await range();
  const box = await browser.run("(() => { const b = document.querySelector('#overlays .u-over').getBoundingClientRect(); return [b.x, b.y, b.width, b.height]; })()");
  await browser.drag([box[0] + 0.3 * box[2], box[1] + 0.5 * box[3]], [box[0] + 0.5 * box[2], box[1] + 0.5 * box[3]]);
  await until('dragging zooms', async () => { const [a, b] = await range(); return b - a < 0.5 * (right - left); });
  const legend = () => browser.run("document.querySelector('#overlays .u-legend').textContent");
  check((await legend()).includes('measured \u2212 nominal'), 'the difference to what was measured comes first');
  check(!(await legend()).includes('-'), 'a legend that nobody points at holds names only');
  await browser.run("[...document.querySelectorAll('#overlays button')].at(-1).click()");
  check((await legend()).includes('nominal') && !(await legend()).includes('\u2212'), 'the signals can be shown');
  check((await browser.run("document.getElementById('causes').textContent")).includes('Causes that lost, and why'), 'the causes that lost are listed');
  // On paper it is black on white, whatever the screen's colours: no buttons, nothing wider than the page, no figure cut in two.
  const dark = [{ name: 'prefers-color-scheme', value: 'dark' }];
  const style = (selector, key) => browser.run(`getComputedStyle(document.querySelector('${selector}')).${key}`);
  await browser.call('Emulation.setEmulatedMedia', { media: 'screen', features: dark });
  check(await style(':root', 'backgroundColor') === 'rgb(18, 23, 28)', 'dark on a dark screen');
  await browser.call('Emulation.setEmulatedMedia', { media: 'print', features: dark });
  await browser.call('Emulation.setDeviceMetricsOverride', { width: 688, height: 1000, deviceScaleFactor: 1, mobile: false }); // A4 less its margins
  for (const [selector, key, wanted] of [[':root', 'backgroundColor', 'rgb(255, 255, 255)'], ['h1', 'color', 'rgb(0, 0, 0)'],
    ['section', 'backgroundColor', 'rgb(255, 255, 255)'], ['.badge', 'color', 'rgb(255, 255, 255)'], ['#map .cell', 'printColorAdjust', 'exact'],
    ['.plot', 'breakInside', 'avoid'], ['.cause', 'breakInside', 'avoid'], ['h2', 'breakAfter', 'avoid']]) {
    const is = await style(selector, key);
    check(is === wanted, `on paper: ${key} of ${selector} is ${is}`);
  }
  check(await browser.run("[...document.querySelectorAll('button')].every((button) => !button.getClientRects().length)"), 'on paper: no buttons');
  await until('on paper: nothing is wider than the page', () => browser.run('document.documentElement.scrollWidth <= innerWidth'));
  await browser.call('Emulation.setEmulatedMedia', { media: '', features: [] });
  await browser.call('Emulation.setDeviceMetricsOverride', { width: 1240, height: 900, deviceScaleFactor: 1, mobile: false });
  check(browser.problems.length === 0, `no errors on the page: ${browser.problems.join('; ')}`);
  if (picture) {
    await browser.run("[...document.querySelectorAll('#overlays button')][0].click(); scrollTo(0, 0)");
    const height = await browser.run('document.documentElement.scrollHeight');
    await browser.call('Emulation.setDeviceMetricsOverride', { width: 1240, height: Math.min(height, 6000), deviceScaleFactor: 1, mobile: false });
    await new Promise((resolve) => setTimeout(resolve, 300));
    await browser.screenshot(picture);
  }
  await browser.close();
} catch (error) {
  console.error(`FAILED: ${error.message}; ${browser.problems.join('; ')}`);
  await browser.close();
  process.exit(1);
}
