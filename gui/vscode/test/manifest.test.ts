import assert from 'node:assert/strict';
import * as fs from 'node:fs';
import { test } from 'node:test';

const read = (file: string) => JSON.parse(fs.readFileSync(file, 'utf8'));
const manifest = read('package.json');

test('every command of the manifest is carried out', () => {
  const commands = manifest.contributes.commands.map((each: { command: string }) => each.command);
  const source = ['src/commands.ts', 'src/debug/past.ts'].map((each) => fs.readFileSync(each, 'utf8')).join('');
  const registered = [...source.matchAll(/'(pendant\.\w+)': /g)].map((each) => each[1]);
  assert.deepEqual(registered.sort(), commands.sort());
});

test('every file that the manifest names is there', () => {
  const text = JSON.stringify(manifest);
  const files = [...text.matchAll(/"(?:\.\/)?((?:images|snippets|syntaxes|walkthrough)\/[^"]+)"/g)].map((each) => each[1]);
  assert.ok(files.length > 8);
  for (const file of files) {
    assert.ok(fs.existsSync(file ?? ''), file);
  }
});

test('messages of Pendant are found in the terminal', () => {
  const form = new RegExp(manifest.contributes.problemPatterns[0].regexp);
  assert.deepEqual(form.exec('cell/pick.script:7:11: error: index is 3, must be 0 to 2')?.slice(1), [
    'cell/pick.script',
    '7',
    '11',
    'error',
    'index is 3, must be 0 to 2',
  ]);
  assert.deepEqual(form.exec('move.script:4: warning: slow')?.slice(1), ['move.script', '4', undefined, 'warning', 'slow']);
  assert.equal(form.exec('  in report, line 7'), null);
  assert.equal(form.exec('  | a.script:1:1: error: said by the program'), null);
});

test('what a task finds does not take the place of what the language server has found', () => {
  const client = /new LanguageClient\('([^']+)'/.exec(fs.readFileSync('src/server/client.ts', 'utf8'))?.[1];
  assert.ok(client !== undefined);
  assert.notEqual(manifest.contributes.problemMatchers[0].owner, client);
});

test('lines that open a block indent, those that end one come back', () => {
  const { indentationRules } = read('language-configuration.json');
  const opens = new RegExp(indentationRules.increaseIndentPattern);
  const closes = new RegExp(indentationRules.decreaseIndentPattern);
  for (const line of ['def f():', '  if a[1] == 2:', 'else:', '  thread t():  # one', 'while True:']) {
    assert.match(line, opens);
  }
  for (const line of ['if a: halt end', 'x = 1', '# if a:', 'endless = 1']) {
    assert.doesNotMatch(line, opens);
  }
  for (const line of ['end', '  elif a:', 'else:']) {
    assert.match(line, closes);
  }
  for (const line of ['endless = 1', 'x = end_of', '# end']) {
    assert.doesNotMatch(line, closes);
  }
});

test('the lock file names no computer', () => {
  const hosts = [...fs.readFileSync('package-lock.json', 'utf8').matchAll(/"resolved": "https?:\/\/([^/"]+)/g)];
  assert.deepEqual([...new Set(hosts.map((each) => each[1]))].filter((each) => each !== 'registry.npmjs.org'), []);
});
