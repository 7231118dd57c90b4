import assert from 'node:assert/strict';
import { test } from 'node:test';
import { switching } from '../src/panel/outputs';
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

test('outputs are switched by the functions of programs, inputs are not', () => {
  assert.equal(switching('digital_out', 3, true), 'set_standard_digital_out(3, True)');
  assert.equal(switching('tool_out', 0, false), 'set_tool_digital_out(0, False)');
  assert.equal(switching('digital_in', 0, true), undefined);
});

test('of many stops the newest are kept, with their numbers', () => {
  const stops = new Stops();
  const stop = { reason: 'step', description: '', function: 'f', line: 1, file: 'f.script', reading: read('ur5e', [], []) };
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
