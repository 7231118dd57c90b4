import assert from 'node:assert/strict';
import { test } from 'node:test';
import { readJunit } from '../src/testing/junit';

const report = (cases: string) =>
  `<?xml version="1.0" encoding="UTF-8"?>
<testsuites name="pendant test" tests="1" failures="0" errors="0" time="0.1">
  <testsuite name="cell/grip_test.script" file="cell/grip_test.script" tests="1" failures="0" errors="0" skipped="0" time="0.1">
    <properties>
      <property name="seed" value="4711"/>
    </properties>
${cases}
  </testsuite>
</testsuites>
`;

const attributes = 'classname="cell.grip_test" time="0.146" file="cell/grip_test.script" line="6"';

test('a test that has passed has its robot time and its output', () => {
  const { tests } = readJunit(
    report(`<testcase name="test_grip" ${attributes}><system-out>closing\nwidth &lt; 5\n</system-out></testcase>`),
  );
  assert.equal(tests.length, 1);
  assert.equal(tests[0]?.status, 'passed');
  assert.equal(tests[0]?.robotTimeMs, 146);
  assert.equal(tests[0]?.output, 'closing\nwidth < 5\n');
});

test('a red test has message, place and call stack', () => {
  const details = [
    'cell/grip.script:2:3: error: width is 0.05 m, expected 0.04 m',
    '  assert_near(width, 0.04, 0.001)',
    '  ^',
    '  in close, cell/grip.script:2:3',
    '  ... 4 more',
    '  in test_grip, cell/grip_test.script:6:5',
  ].join('\n');
  const { tests } = readJunit(
    report(
      `<testcase name="test_grip[0.05, True]" ${attributes}>
        <failure message="width is 0.05 m, expected 0.04 m" type="assert_near">${details}</failure></testcase>`,
    ),
  );
  const red = tests[0];
  assert.equal(red?.name, 'test_grip[0.05, True]');
  assert.equal(red?.status, 'failed');
  assert.equal(red?.message, 'width is 0.05 m, expected 0.04 m');
  assert.equal(red?.details, details);
  assert.deepEqual(red?.place, { file: 'cell/grip.script', line: 1, column: 2 });
  assert.deepEqual(
    red?.stack.map((each) => [each.name, each.place.line]),
    [
      ['close', 1],
      ['test_grip', 5],
    ],
  );
});

test('without a place in the text the line of the test stands in', () => {
  const { tests } = readJunit(
    report(`<testcase name="test_grip" ${attributes}><error message="timed out" type="timed-out">x</error></testcase>`),
  );
  assert.equal(tests[0]?.status, 'error');
  assert.deepEqual(tests[0]?.place, { file: 'cell/grip_test.script', line: 5, column: 0 });
});

test('a skipped test says why', () => {
  const { tests } = readJunit(
    report(`<testcase name="test_grip" ${attributes}><skipped message="no camera"/></testcase>`),
  );
  assert.equal(tests[0]?.status, 'skipped');
  assert.equal(tests[0]?.message, 'no camera');
});

test('a file of which no test could run is told apart', () => {
  const { tests, broken } = readJunit(
    report(
      `<testcase name="(the file itself)" classname="a" time="0" file="a_test.script">
        <error message="no test of the file could run" type="broken-file">a_test.script:3:1: error: end is missing</error>
      </testcase>`,
    ),
  );
  assert.deepEqual(tests, []);
  assert.deepEqual(broken, [
    {
      file: 'a_test.script',
      message: 'a_test.script:3:1: error: end is missing',
      place: { file: 'a_test.script', line: 2, column: 0 },
    },
  ]);
});

test('a report that is cut off is refused', () => {
  const whole = report(`<testcase name="test_grip" ${attributes}/>`);
  assert.throws(() => readJunit(whole.slice(0, whole.length / 2)));
  assert.throws(() => readJunit(''));
});
