import assert from 'node:assert/strict';
import { test } from 'node:test';
import { readLcov } from '../src/testing/lcov';

test('lines, conditions and functions are read for each file', () => {
  const files = readLcov(
    [
      'TN:',
      'SF:cell/pick.script',
      'FN:1,pick',
      'FNDA:2,pick',
      'FNF:1',
      'BRDA:3,0,0,2',
      'BRDA:3,0,1,-',
      'DA:2,2',
      'DA:3,0',
      'end_of_record',
      'TN:',
      'SF:b.script',
      'DA:1,1',
      'end_of_record',
      '',
    ].join('\n'),
  );
  assert.deepEqual(files, [
    {
      file: 'cell/pick.script',
      lines: [
        { line: 1, count: 2 },
        { line: 2, count: 0 },
      ],
      branches: [
        { line: 2, label: 'condition is True', count: 2 },
        { line: 2, label: 'condition is False', count: 0 },
      ],
      functions: [{ name: 'pick', line: 0, count: 2 }],
    },
    { file: 'b.script', lines: [{ line: 0, count: 1 }], branches: [], functions: [] },
  ]);
});
