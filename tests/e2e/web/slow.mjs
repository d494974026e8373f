// A page in a browser that draws two pictures a second: no robot may come apart. node slow.mjs URL PICTURE
import { Browser } from './browser.mjs';
import { check, giveUp, until } from './check.mjs';

const [url, picture] = process.argv.slice(2);
const browser = await Browser.open('about:blank', { width: 960, height: 600 });
try {
  // A picture that takes half a second: its time is that of its start, messages wait until it is done.
  await browser.call('Page.addScriptToEvaluateOnNewDocument', { source: `
    const draw = window.requestAnimationFrame.bind(window);
    window.reaches = [];
    window.requestAnimationFrame = (picture) => draw((start) => {
      picture(start - 400);
      window.reaches.push(window.plumbline?.state().reach ?? 0);
      while (performance.now() < start + 500);
    });` });
  await browser.call('Page.navigate', { url: `${url}?quality=low&camera=ball` });
  await until('a robot is there and walks', async () => {
    const state = await browser.run('window.plumbline?.state()');
    return state?.robots.length === 1 && state.time > 4;
  });
  const begin = await browser.run('window.reaches.length');
  await until('25 more pictures', async () => await browser.run('window.reaches.length') >= begin + 25);
  await browser.screenshot(picture);
  const furthest = await browser.run('Math.max(...window.reaches)');
  check(furthest > 0.2 && furthest < 0.55, `no body is further than 0.55 m from its torso in any picture: ${furthest.toFixed(2)} m`);
  check(browser.problems.length === 0, `no errors on the page: ${browser.problems.join('; ')}`);
  await browser.close();
} catch (error) {
  await giveUp(browser, error, () => browser.run('window.plumbline?.state()'), 'build/e2e/slow-failed.png');
}
