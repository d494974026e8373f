// A motion edited in the page of an agent: node keyframes.mjs ADDRESS FOLDER-OF-MOTIONS PICTURE
import { appendFileSync, readFileSync } from 'node:fs';
import { Browser } from './browser.mjs';
import { check, giveUp, until } from './check.mjs';

const [address, folder, picture] = process.argv.slice(2);
const text = () => readFileSync(`${folder}/wave.yaml`, 'utf8');
const browser = await Browser.open(`${address}?quality=low&fps=2`, { width: 1600, height: 1000 });
const run = (expression) => browser.run(expression);
const ask = (command) => run(`plumbline.link.ask(${JSON.stringify(command)})`);
const state = () => run('document.getElementById("editorState").textContent');
const click = (id) => run(`document.getElementById("${id}").click()`);
const type = (expression, value) => run(`(() => { const input = ${expression}; input.value = ${value}; input.dispatchEvent(new Event('input')); input.dispatchEvent(new Event('change')); })()`);
const slider = (joint) => `document.querySelector('.cell[data-joint="${joint}"] input[type="range"]')`;
const number = (joint) => `document.querySelector('.cell[data-joint="${joint}"] input[type="number"]')`;
const opened = () => run('Boolean(window.plumbline?.editor.isOpen && plumbline.editor.motion && plumbline.editor.joints)');
// A reload keeps what the browser keeps; the question whether to leave is answered.
async function reload() {
  await run('window.old = true');
  browser.call('Page.reload').catch(() => {});
  await new Promise((resolve) => setTimeout(resolve, 500));
  await browser.call('Page.handleJavaScriptDialog', { accept: true }).catch(() => {});
  await until('the page is there again', async () => { try { return !(await run('Boolean(window.old)')) && await opened(); } catch { return false; } });
}

try {
  await until('an agent started with a motion shows its keyframes', opened);
  check((await run('plumbline.editor.motion.name')) === 'wave', 'it is the one of the command line');
  check((await run('document.querySelectorAll(".ruler .key").length')) === 6, 'each keyframe is on the time line');
  check((await run('plumbline.editor.joints.rows.size')) === (await ask('get module:MotionEditor:robot'))[0].value.filter((l) => l.joint).length, 'each joint of the robot has a slider');
  check((await run(`${slider('LElbowRoll')}.min + " " + ${slider('LElbowRoll')}.max`)) === '-90 1', 'over what the joint can do');

  // A slider moves the figure, not yet the file.
  const before = text(), figure = () => run('[...plumbline.editor.figures.shown[0].poses].map((x) => Math.round(1e4 * x)).join()');
  await click('bothSides');
  const stood = await figure();
  await type(slider('LShoulderRoll'), 60);
  await until('the figure moves with the slider', async () => (await figure()) !== stood);
  check(/not saved/.test(await state()), 'the page says that it is not saved');
  check(text() === before, 'and the file is as it was');
  await click('editorUndo');
  await until('undo takes it back', async () => (await figure()) === stood && !/not saved/.test(await state()));
  await click('editorRedo');

  // What is impossible is said at once, and by saving nothing is written.
  await type(number('LElbowRoll'), 45);
  await until('an impossible angle is refused in the agent\'s words', async () => /45 degrees is out of the limits -90 to 1 of LElbowRoll/.test(await state()));
  await click('editorSave');
  await new Promise((resolve) => setTimeout(resolve, 500));
  check(text() === before, 'nothing impossible is written');
  await click('editorUndo');
  await until('it is possible again', async () => !/limits/.test(await state()));

  // What is not saved outlives the page.
  await reload();
  await until('what was not saved is back', async () => /Unsaved changes/.test(await state()) && (await run('plumbline.editor.motion.keyframes[0].joints.LShoulderRoll')) === 60);

  // Saved: in the file with its comments, and played.
  await type('document.getElementById("editorTimeOf")', 0.6);
  const plays = () => run('document.getElementById("editorPlaying").textContent');
  await run('plumbline.played = []; plumbline.link.watch("representation:MotionSelection.specialAction", "", (name) => plumbline.played.push(name))');
  await click('editorSave');
  await until('it is in the file', () => /- \{time: 0\.6, LShoulderPitch: -80, LShoulderRoll: 60\}/.test(text()));
  check(text().startsWith(before.slice(0, before.indexOf('keyframes:'))), 'and its comments are');
  await until('the robot plays it', () => run('plumbline.played.includes("(draft)")'));
  await until('once', async () => /stand|^$/.test(await plays()) || !/plays it/.test(await plays()));
  check((await run('plumbline.editor.motion.changed')) === false, 'nothing is left to save');
  await browser.screenshot(picture);

  // From here, and a keyframe more.
  await run('document.querySelector(".ruler .key[data-keyframe=\\"3\\"]").click()');
  await click('editorFrom');
  await until('the keyframe that was chosen is where it begins', async () => (await ask('get module:MotionEditor:draft.first'))[0].value === 3);
  await click('editorAdd');
  check((await run('document.querySelectorAll(".ruler .key").length')) === 7, 'a keyframe is added');

  // Somebody else writes the file: theirs stays until one decides.
  appendFileSync(`${folder}/wave.yaml`, '# theirs\n');
  await click('editorSave');
  await until('a file that was changed meanwhile is not overwritten', async () => /Somebody else has changed the file/.test(await state()) && !(await run('document.getElementById("editorKeep").hidden')));
  check(/# theirs\n$/.test(text()), 'theirs is there');
  await click('editorKeep');
  await until('one keeps what one has', async () => !(await run('document.getElementById("editorSave").disabled')));
  await click('editorSave');
  await until('and both are in the file', () => (text().match(/^ {2}- /gm) ?? []).length === 7 && /# theirs\n$/.test(text()));

  await run('plumbline.played.length = 0');
  await click('editorBack');
  await until('the agent goes on with the motion as it is now', () => run('plumbline.played.includes("wave")'));
  const problems = browser.problems.filter((line) => !/WebSocket|ERR_CONNECTION|beforeunload/.test(line));
  check(problems.length === 0, `no errors on the page ${problems.join('; ')}`);
  await browser.close();
  process.exit(0);
} catch (error) {
  await giveUp(browser, error, state, 'build/e2e/keyframes-failed.png');
}
