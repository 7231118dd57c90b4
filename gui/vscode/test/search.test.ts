import assert from 'node:assert/strict';
import { test } from 'node:test';
import { search, type Surroundings } from '../src/executable/search';

function around(programs: string[], more: Partial<Surroundings> = {}): Surroundings {
  return {
    platform: 'linux',
    home: '/home/ann',
    searchPath: '/usr/bin:/opt/tools',
    setting: '',
    folder: '/home/ada/cell',
    extension: '/ext',
    isProgram: (file) => programs.includes(file),
    isFolder: (file) => programs.some((each) => each.startsWith(`${file}/`)),
    ...more,
  };
}

test('the first program in the PATH is found', () => {
  const found = search(around(['/opt/tools/pendant', '/usr/bin/pendant']));
  assert.deepEqual(found, { found: true, file: '/usr/bin/pendant', by: 'PATH' });
});

test('a relative folder in the PATH is left out', () => {
  assert.equal(search(around(['pendant', './pendant'], { searchPath: '.:' })).found, false);
});

test('usual places are looked at after the PATH', () => {
  const found = search(around(['/home/ann/.local/bin/pendant']));
  assert.deepEqual(found, { found: true, file: '/home/ann/.local/bin/pendant', by: 'usual place' });
});

test('a Pendant that comes with the extension comes before those installed by hand', () => {
  const found = search(around(['/home/ann/bin/pendant', '/ext/pendant/pendant']));
  assert.equal(found.found && found.file, '/ext/pendant/pendant');
});

test('the setting names a program', () => {
  const found = search(around(['/x/pendant-2', '/usr/bin/pendant'], { setting: '/x/pendant-2' }));
  assert.deepEqual(found, { found: true, file: '/x/pendant-2', by: 'setting' });
});

test('the setting names the folder of the program', () => {
  const found = search(around(['/x/pendant/pendant'], { setting: '/x/pendant' }));
  assert.equal(found.found && found.file, '/x/pendant/pendant');
});

test('the setting may begin at home, and in the folder that is open', () => {
  for (const [setting, file] of [
    ['~/p/pendant', '/home/ann/p/pendant'],
    ['tools/pendant', '/home/ada/cell/tools/pendant'],
    ['${workspaceFolder}/tools/pendant', '/home/ada/cell/tools/pendant'],
  ] as const) {
    const found = search(around([file], { setting }));
    assert.equal(found.found && found.file, file);
  }
});

test('a setting that leads nowhere is said, and nothing else is taken in its place', () => {
  const found = search(around(['/usr/bin/pendant'], { setting: '/x/pendant' }));
  assert.deepEqual(found, {
    found: false,
    why: 'The setting pendant.path is /x/pendant, which is not a program.',
    looked: ['/x/pendant'],
  });
});

test('where nothing is found the places are told in their order', () => {
  const found = search(around([]));
  assert.ok(!found.found);
  assert.deepEqual(found.looked.slice(0, 3), ['/usr/bin', '/opt/tools', '/ext/pendant']);
});
