import assert from 'node:assert/strict';
import { test } from 'node:test';
import { functionOf, selection } from '../src/testing/selection';

test('whole files need no filter', () => {
  assert.deepEqual(
    selection([
      { file: 'a_test.script', name: undefined },
      { file: 'b_test.script', name: undefined },
    ]),
    ['--', 'a_test.script', 'b_test.script'],
  );
});

test('a test is named with its file', () => {
  assert.deepEqual(selection([{ file: 'a_test.script', name: 'test_x[1, 2]' }]), [
    '--filter',
    'a_test.script:test_x[1, 2]',
    '--',
    'a_test.script',
  ]);
});

test('a whole file beside a test of another one is not cut by the filter', () => {
  assert.deepEqual(
    selection([
      { file: 'a_test.script', name: 'test_x' },
      { file: 'b_test.script', name: undefined },
    ]),
    ['--filter', 'a_test.script:test_x', '--filter', 'b_test.script:', '--', 'a_test.script', 'b_test.script'],
  );
});

test('the function of a case is what stands before its bracket', () => {
  assert.equal(functionOf('test_x["[", 2]'), 'test_x');
  assert.equal(functionOf('test_x'), 'test_x');
});
