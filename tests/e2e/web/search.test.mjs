// Parts of a search's page that need no browser: node --test tests/e2e/web/search.test.mjs
import assert from 'node:assert/strict';
import test from 'node:test';
globalThis.document = { getElementById: () => null };
const { duration, left } = await import('../../../web/js/search/numbers.js');
const { place } = await import('../../../web/js/search/parameters.js');

test('times as one reads them', () => {
  assert.deepEqual([0.4, 59, 61, 7325, NaN].map(duration), ['0 s', '59 s', '1 min 1 s', '2 h 2 min', '-']);
});

test('what is left follows from the pace since the page knows the search', () => {
  const begin = { generation: 10, runs: 100, seconds: 5 };
  assert.equal(left({ generation: 20, runs: 200, seconds: 15, live: true }, { maxGenerations: 60, maxRuns: null }, begin), 40);
  assert.equal(left({ generation: 20, runs: 200, seconds: 15, live: true }, { maxGenerations: 60, maxRuns: 300 }, begin), 10);
  assert.equal(left({ generation: 10, runs: 100, seconds: 5, live: true }, { maxGenerations: 60 }, begin), null);
  assert.equal(left({ generation: 20, runs: 200, seconds: 15, live: true }, {}, begin), null);
  assert.equal(left({ generation: 20, runs: 200, seconds: 15, live: false }, { maxGenerations: 60 }, begin), null);
});

test('a value has its place between its bounds', () => {
  assert.equal(place({ start: 0, lower: -1, upper: 3 }, 1), 0.5);
  assert.equal(place({ start: 0, lower: -1, upper: 3 }, 9), 1);
  assert.equal(place({ start: 2, lower: null, upper: null }, 2), 0.5);
});
