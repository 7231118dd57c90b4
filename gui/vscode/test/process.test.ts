import assert from 'node:assert/strict';
import * as fs from 'node:fs';
import * as os from 'node:os';
import * as path from 'node:path';
import { after, test } from 'node:test';
import { runTests } from '../src/testing/process';

const folder = fs.mkdtempSync(path.join(os.tmpdir(), 'pendant-process-'));
after(() => fs.rmSync(folder, { recursive: true }));

/** A program that stands in for Pendant. */
function standIn(body: string): string {
  const file = path.join(folder, `pendant-${body.length}`);
  fs.writeFileSync(file, `#!/bin/sh\n${body}\n`, { mode: 0o755 });
  return file;
}

const whole = '<testsuites><testsuite><testcase name="test_a" file="a_test.script" line="1" time="0"/></testsuite></testsuites>';

test('the report of a run is read, its arguments are those that are given', async () => {
  let output = '';
  const result = await runTests(
    {
      command: standIn(`echo "$1 $2 $4 $5 $6 $7 $8"; printf '%s' '${whole}' > "$3"; exit 1`),
      folder,
      arguments: ['--', 'a_test.script'],
      coverage: false,
    },
    (text) => (output += text),
    new AbortController().signal,
  );
  assert.equal(output, 'test --junit --verbose --color always -- a_test.script\n');
  assert.deepEqual(
    result.report.tests.map((each) => each.name),
    ['test_a'],
  );
});

test('a run without a report is an error', async () => {
  const command = standIn('echo "there is no such option" >&2; exit 2');
  await assert.rejects(
    runTests({ command, folder, arguments: [], coverage: false }, () => {}, new AbortController().signal),
    /ended with 2 and wrote no report/,
  );
});

test('a command that is not there is an error', async () => {
  const command = path.join(folder, 'nothing');
  await assert.rejects(
    runTests({ command, folder, arguments: [], coverage: false }, () => {}, new AbortController().signal),
    /ENOENT/,
  );
});
