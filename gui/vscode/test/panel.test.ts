import assert from 'node:assert/strict';
import { test } from 'node:test';
import { offers } from '../src/debug/moments';
import { appended, readingOf, share, timelineOf } from '../src/panel/live';
import { fileOf } from '../src/panel/place';
import { read } from '../src/panel/reading';
import { Stops } from '../src/panel/stops';

const robot = [
  { name: 'time', value: '3.218 s' },
  { name: 'safety_mode', value: 'normal' },
  { name: 'actual_q', value: '[0, -1.57, 1.57, -1.57, -1.57, 6.1e-05]' },
  { name: 'actual_tcp', value: '[0.1, -0.2, 0.3, 0, 3.14, 0]' },
];

test('the robot is read from the texts of its scopes', () => {
  const reading = read('ur10e', robot, [
    { name: 'digital_out', value: '[True, False, False, False, False, False, False, False]' },
    { name: 'analog_in', value: '[0, 7.5]' },
  ]);
  assert.equal(reading.time, '3.218 s');
  assert.deepEqual(reading.joints, [0, -1.57, 1.57, -1.57, -1.57, 6.1e-5]);
  assert.equal(reading.tcp[4], 3.14);
  assert.deepEqual(reading.facts, [{ name: 'safety_mode', value: 'normal' }]);
  assert.deepEqual(
    reading.banks.map((each) => [each.name, each.on.length, each.on[0]]),
    [['digital_out', 8, true]],
  );
  assert.deepEqual(reading.analog, [{ name: 'analog_in', value: '[0, 7.5]' }]);
});

test('what is not told, or in another form, is left out', () => {
  const reading = read('ur5e', [{ name: 'actual_q', value: '[1, 2, ...]' }], [{ name: 'digital_in', value: '?' }]);
  assert.deepEqual([reading.joints, reading.tcp, reading.banks], [[], [], []]);
});

test('what the adapter tells beyond the protocol is read as a stop is', () => {
  const answer = { state: 'running', arm: 'ur3e', timeS: 4, fromS: 1, nowS: 3, robot, signals: [] } as const;
  assert.equal(readingOf(answer).arm, 'ur3e');
  assert.equal(readingOf(answer).joints.length, 6);
  assert.deepEqual(timelineOf(answer), { fromS: 1, nowS: 3, atS: 3 });
  assert.equal(share(timelineOf(answer), 1.5), 0.25);
  assert.equal(share({ fromS: 2, nowS: 2, atS: 2 }, 2), 0);
});

test('lines of output are added once, and the newest are kept', () => {
  const line = (id: number) => ({ id, timeS: id, text: `line ${id}` });
  const known = appended([line(1)], [line(1), line(2)]);
  assert.deepEqual(known.map((each) => each.id), [1, 2]);
  assert.equal(appended(known, []), known);
  const many = appended(known, Array.from({ length: 600 }, (_, i) => line(i + 3)));
  assert.deepEqual([many.length, many[499]?.id], [500, 602]);
});

test('moments are offered by their output, the newest first', () => {
  const lines = [
    { id: 1, timeS: 0.5, line: 4, text: 'on my way' },
    { id: 2, timeS: 1.25, text: '' },
  ];
  assert.deepEqual(offers(lines, undefined), [
    { label: '(an empty line)', description: '1.250 s', id: 2 },
    { label: 'on my way', description: '0.500 s, line 4', id: 1 },
  ]);
  assert.deepEqual(offers(lines, 4).map((each) => each.id), [1]);
});

test('of many stops the newest are kept, with their numbers', () => {
  const stops = new Stops();
  const stop = { reason: 'step', description: '', function: 'f', line: 1, file: 'f.script', timeS: 0, reading: read('ur5e', [], []) };
  for (let i = 0; i < 250; i++) {
    stops.add(stop);
  }
  assert.equal(stops.all.length, 200);
  assert.equal(stops.last?.number, 250);
  assert.equal(stops.find(50), undefined);
  stops.clear();
  assert.equal(stops.add(stop).number, 1);
});

test('the file of a stop is found whatever form its path has', () => {
  assert.equal(fileOf('/cell/a.script'), '/cell/a.script');
  assert.equal(fileOf('file:///cell/a%20b.script'), '/cell/a b.script');
  assert.equal(fileOf({ scheme: 'vscode-remote', authority: 'wsl', path: '/cell/a.script' }), '/cell/a.script');
  assert.equal(fileOf('debug:///generated'), undefined);
  assert.equal(fileOf(undefined), undefined);
});
