/** Where the `pendant` command is looked for, without VS Code: setting, PATH, usual places. */
import * as path from 'node:path';

/** What there is to look at. */
export interface Surroundings {
  readonly platform: NodeJS.Platform;
  readonly home: string;
  /** The variable PATH. */
  readonly searchPath: string;
  /** The setting `pendant.path`; empty where nothing is set. */
  readonly setting: string;
  /** The first folder that is open; relative settings count from there. */
  readonly folder: string | undefined;
  /** The folder of this extension, in which Pendant may be bundled. */
  readonly extension: string;
  isProgram(file: string): boolean;
  isFolder(file: string): boolean;
}

export type Search =
  | { readonly found: true; readonly file: string; readonly by: 'setting' | 'PATH' | 'usual place' }
  | { readonly found: false; readonly why: string; readonly looked: readonly string[] };

/** Finds the command. What the setting says is the only place, if it says something. */
export function search(around: Surroundings): Search {
  const names = around.platform === 'win32' ? ['pendant.exe', 'pendant.cmd', 'pendant.bat'] : ['pendant'];
  if (around.setting.trim() !== '') {
    return bySetting(around, names);
  }
  const separator = around.platform === 'win32' ? ';' : ':';
  const inPath = around.searchPath.split(separator).filter((each) => path.isAbsolute(each));
  const places = [...inPath, ...usualPlaces(around)];
  for (const [i, folder] of places.entries()) {
    const file = programIn(folder, names, around);
    if (file !== undefined) {
      return { found: true, file, by: i < inPath.length ? 'PATH' : 'usual place' };
    }
  }
  return { found: false, why: 'The command pendant was not found.', looked: places };
}

function bySetting(around: Surroundings, names: readonly string[]): Search {
  const file = expand(around.setting.trim(), around);
  if (around.isProgram(file)) {
    return { found: true, file, by: 'setting' };
  }
  const inside = around.isFolder(file) ? programIn(file, names, around) : undefined;
  if (inside !== undefined) {
    return { found: true, file: inside, by: 'setting' };
  }
  const why = around.isFolder(file)
    ? `There is no command pendant in the folder ${file} of the setting pendant.path.`
    : `The setting pendant.path is ${file}, which is not a program.`;
  return { found: false, why, looked: [file] };
}

function programIn(folder: string, names: readonly string[], around: Surroundings): string | undefined {
  return names.map((name) => path.join(folder, name)).find((file) => around.isProgram(file));
}

function expand(setting: string, around: Surroundings): string {
  let file = setting.replace(/^~(?=$|[\\/])/, around.home);
  if (around.folder !== undefined) {
    file = file.replaceAll('${workspaceFolder}', around.folder);
  }
  return path.resolve(around.folder ?? around.home, file);
}

function usualPlaces(around: Surroundings): string[] {
  const bundled = path.join(around.extension, 'pendant');
  if (around.platform === 'win32') {
    return [bundled, path.join(around.home, 'pendant')];
  }
  return [
    bundled,
    path.join(around.home, '.local/bin'),
    path.join(around.home, 'bin'),
    path.join(around.home, 'pendant'),
    '/usr/local/bin',
    '/opt/homebrew/bin',
    '/opt/pendant',
    '/opt/pendant/bin',
  ];
}
