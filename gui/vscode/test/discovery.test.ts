import assert from 'node:assert/strict';
import { test } from 'node:test';
import { discover, holdsTests } from '../src/testing/discovery';

const names = (text: string) => discover(text).map((each) => each.name);

test('files whose name ends in _test.script hold tests', () => {
  assert.ok(holdsTests('/cell/pick_test.script'));
  assert.ok(!holdsTests('/cell/pick.script'));
  assert.ok(!holdsTests('/cell/pick_test.urscript'));
});

test('functions that begin with test_ are tests, at the place of their name', () => {
  const found = discover('def helper():\nend\n\ndef  test_grip( width ):\nend\n');
  assert.deepEqual(found, [{ name: 'test_grip', line: 3, column: 5, tags: [], cases: [], skipped: undefined }]);
});

test('functions within functions are no tests', () => {
  assert.deepEqual(
    names('def test_a():\n  if True: halt end\n  def test_inner():\n  end\nend\ndef test_b():\nend\n'),
    ['test_a', 'test_b'],
  );
});

test('words in strings, comments and names of members open no blocks', () => {
  assert.deepEqual(
    names('def test_a():\n  textmsg("if") # while\n  s.end = 1\n  x.sec = my_end\nend\ndef test_b():\nend'),
    ['test_a', 'test_b'],
  );
});

test('one that is commented out is none', () => {
  assert.deepEqual(names('# def test_a():\n# end\n'), []);
});

test('marks stand in the comments right above', () => {
  const [first, second] = discover(
    '# @tag fast, gripper\n# says something\n# @skip no camera yet\ndef test_a():\nend\n\ndef test_b():\nend\n',
  );
  assert.deepEqual(first?.tags, ['fast', 'gripper']);
  assert.equal(first?.skipped, 'no camera yet');
  assert.deepEqual(second?.tags, []);
  assert.equal(second?.skipped, undefined);
});

test('the cases of a table are told in their order', () => {
  const [found] = discover('# @case 0.1, True\n#   @case  [1, 2], "x"  \n# @case 0.1, True\ndef test_a(x, y):\nend\n');
  assert.deepEqual(found?.cases, ['0.1, True', '[1, 2], "x"']);
});

test('an empty line parts a comment from the test below', () => {
  assert.deepEqual(discover('# @tag fast\n\ndef test_a():\nend\n')[0]?.tags, []);
});

test('all line ends count', () => {
  assert.deepEqual(
    discover('x = 1\r\n\rdef test_a():\rend').map((each) => each.line),
    [2],
  );
});
