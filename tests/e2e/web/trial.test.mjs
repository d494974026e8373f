// The robot tries a motion, and somebody wants something else meanwhile: node --test tests/e2e/web/trial.test.mjs
import assert from 'node:assert/strict';
import { register } from 'node:module';
import test from 'node:test';

// What draws is not there.
const figures = `data:text/javascript,${encodeURIComponent('export class Figures {}')}`;
register(`data:text/javascript,${encodeURIComponent(`export const resolve = (name, context, next) =>
  (name === './figures.js' ? { url: ${JSON.stringify(figures)}, shortCircuit: true } : next(name, context));`)}`);

const element = () => ({ append() {}, setAttribute() {}, textContent: '' });
globalThis.document = { createElement: element, getElementById: element };
const { Editor } = await import('../../../web/js/agent/editor.js');
const { Motions } = await import('../../../web/js/agent/motions.js');
const { Trial } = await import('../../../web/js/agent/trial.js');

// An agent that answers when the test says so.
class Link {
  asked = [];
  waiting = [];
  watch(name, period, took) { this.took = took; }
  ask(command) {
    this.asked.push(command.split(' ').slice(0, 2).join(' '));
    return new Promise((resolve) => { this.waiting.push(resolve); });
  }
  async answer(value) {
    this.waiting.shift()(value);
    for (let i = 0; i < 10; ++i) await null;
  }
}

const parts = () => {
  const link = new Link(), motions = new Motions({ place: element(), link });
  return { link, trial: new Trial({ link, motions, onState() {} }) };
};
const motion = { name: 'wave', keyframes: [{}, {}], changed: true, draftText: () => '{}', fileText: () => '{}', take() {} };
const request = 'representation:MotionRequest';

test('a robot that is handed back while it is asked is asked no more', async () => {
  const { link, trial } = parts();
  trial.play(motion, 0);
  await link.answer();
  assert.deepEqual(link.asked, ['set module:MotionEditor:draft', `set ${request}.specialAction`]);
  trial.handBack();
  await link.answer();
  await link.answer();
  assert.equal(link.asked.at(-1), `unset ${request}`);
  link.took('(draft)');
  assert.equal(link.asked.length, 3);
});

test('what is saved is not played if the robot was handed back before the file was written', async () => {
  const { link, trial } = parts();
  const editor = Object.assign(Object.create(Editor.prototype), {
    link, trial, motion, drafts: { drop() {} }, file: async () => ({}), listNames() {}, show() {}, status() {} });
  editor.save();
  assert.deepEqual(link.asked, ['set motion:wave']);
  trial.handBack();
  await link.answer();
  await link.answer();
  assert.deepEqual(link.asked, ['set motion:wave', `unset ${request}`]);
  editor.save();
  await link.answer();
  assert.equal(link.asked.at(-1), 'set module:MotionEditor:draft');
});
