import assert from 'node:assert/strict';
import { test } from 'node:test';
import { complete, isProgram } from '../src/debug/configuration';

test('without a launch.json the open program is debugged', () => {
  assert.deepEqual(complete({}, '/cell/pick.script'), {
    ok: true,
    configuration: { type: 'pendant', request: 'launch', name: 'Debug', program: '/cell/pick.script' },
  });
});

test('what is written stays', () => {
  const written = { type: 'pendant', request: 'launch', name: 'Mine', program: 'a.script', robot: 'ur10e' };
  assert.deepEqual(complete(written, '/cell/pick.script'), { ok: true, configuration: written });
});

test('the arm of the settings is taken where nothing says which arm there is', () => {
  const robot = (written: object) => {
    const completed = complete({ program: 'a.script', ...written }, undefined, 'ur10e');
    return completed.ok ? completed.configuration['robot'] : undefined;
  };
  assert.equal(robot({}), 'ur10e');
  assert.equal(robot({ robot: 'ur3e' }), 'ur3e');
  assert.equal(robot({ installation: 'cell.pinst' }), undefined);
  assert.equal(robot({ program: 'a.pendant' }), undefined);
});

test('a file that is no program is not debugged', () => {
  const completed = complete({}, '/cell/notes.txt');
  assert.ok(!completed.ok);
  assert.match(completed.why, /no program/);
});

test('attach needs no program', () => {
  const completed = complete({ type: 'pendant', request: 'attach', name: 'There', port: 5 }, undefined);
  assert.deepEqual(completed.ok && completed.configuration, {
    type: 'pendant',
    request: 'attach',
    name: 'There',
    port: 5,
  });
});

test('attach needs a port', () => {
  for (const port of [undefined, 0, 65536, 'x']) {
    const completed = complete({ type: 'pendant', request: 'attach', name: 'There', port }, undefined);
    assert.ok(!completed.ok);
    assert.match(completed.why, /no port/);
  }
});

test('scripts and trees are programs', () => {
  for (const file of ['a.script', 'A.SCRIPT', 'a.urscript', 'a.pendant', 'a.urp']) {
    assert.ok(isProgram(file), file);
  }
  assert.ok(!isProgram('a.installation'));
});

test('a test has the arm that its own options say', () => {
  const completed = complete({ program: '/cell/a_test.script', test: 'test_a' }, undefined, 'ur10e');
  assert.ok(completed.ok);
  assert.equal(completed.configuration['robot'], undefined);
  assert.equal(completed.configuration['test'], 'test_a');
});
