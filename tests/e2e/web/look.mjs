// Not a test: starts nothing, looks at a page and writes a picture of it.
//   node tests/e2e/web/look.mjs URL FILE [WIDTH HEIGHT] [SECONDS] [EXPRESSION...]
import { Browser } from './browser.mjs';

const [url, file, width = 1280, height = 720, seconds = 5, ...expressions] = process.argv.slice(2);
const browser = await Browser.open(url, { width: Number(width), height: Number(height) });
await new Promise((r) => setTimeout(r, 1000 * Number(seconds)));
for (const e of expressions) console.log(await browser.run(e));
if (expressions.length) await new Promise((r) => setTimeout(r, 3000));
await browser.screenshot(file);
console.log(JSON.stringify(await browser.run('window.plumbline && (({robots, ...rest}) => ({...rest, robots: robots.length}))(window.plumbline.state())') ?? null));
console.log(browser.problems.slice(0, 10).join('\n'));
await browser.close();
