// The report of the gap diagnosis, opened from disk in a browser: it says its verdict, draws its map and its curves,
// and asks nothing of a network.
//   report.mjs PAGE WORDS [PICTURE]   WORDS: what the verdict's sentence must hold
import { pathToFileURL } from 'node:url';
import { Browser } from '../web/browser.mjs';
import { check, until } from '../web/check.mjs';

const [page, words, picture] = process.argv.slice(2);
const browser = await Browser.open(pathToFileURL(page).href, { width: 1240, height: 900 });
try {
  await until('the page is put together', () => browser.run("document.body?.dataset.ready === 'yes'"));
  const sentence = await browser.run("document.getElementById('sentence').textContent");
  check(sentence.includes(words), `the verdict says '${words}': '${sentence}'`);
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
