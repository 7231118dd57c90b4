import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Progress } from '../src/testing/progress';

const OUTPUT = `\u001b[32m✓\u001b[0m tests/a_test.script: 2 passed in 1 min 3 s
  \u001b[32m✓\u001b[0m test_one in 1 min 2 s
  ✓ test_two["in 3 s", [1, 2]] in 0.252 s
✗ b_test.script: 1 passed, 1 failed, 1 skipped in 3.8 s
  ✗ test_three: is 10, must be 11 (b_test.script:11:3)
  ○ test_four: no camera
  ✓ test_five in 3.8 s
`;

const EXPECTED = [
  { file: 'tests/a_test.script', name: 'test_one' },
  { file: 'tests/a_test.script', name: 'test_two["in 3 s", [1, 2]]' },
  { file: 'b_test.script', name: 'test_five' },
];

test('passed tests are told with their file', () => {
  assert.deepEqual(new Progress().take(OUTPUT), EXPECTED);
});

test('pieces may be cut anywhere', () => {
  for (let cut = 0; cut <= OUTPUT.length; cut++) {
    const progress = new Progress();
    assert.deepEqual([...progress.take(OUTPUT.slice(0, cut)), ...progress.take(OUTPUT.slice(cut))], EXPECTED);
  }
});
