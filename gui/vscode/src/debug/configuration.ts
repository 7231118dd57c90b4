/** Debug configurations, without VS Code: what is filled in, and what is missing. */

/** What people have written, or an object without anything where there is no launch.json. */
export type Written = { readonly [name: string]: unknown };

export type Completed =
  | { readonly ok: true; readonly configuration: Written & { type: string; request: string; name: string } }
  | { readonly ok: false; readonly why: string };

const PROGRAMS = /\.(script|urscript|pendant|urp|urpx)$/i;
const SCRIPTS = /\.(script|urscript)$/i;

/** Whether a file by this name can be run. */
export function isProgram(file: string): boolean {
  return PROGRAMS.test(file);
}

/** The arm for a program: that of the settings, if they name one, for scripts; a tree has one of its own. */
export function armFor(program: string, chosen: string | undefined): string | undefined {
  return program === '${file}' || SCRIPTS.test(program) ? chosen : undefined;
}

/**
 * Fills in what is missing.
 *
 * @param open the file of the editor, if there is one on the disk
 * @param robot the arm of people's settings, if they name one
 */
export function complete(written: Written, open: string | undefined, robot?: string): Completed {
  const request = text(written['request']) ?? 'launch';
  const type = text(written['type']) ?? 'pendant';
  if (request !== 'launch') {
    if (attachPort(written) === undefined) {
      return { ok: false, why: 'There is no port to attach to: "port" in launch.json is that of pendant serve --dap.' };
    }
    return { ok: true, configuration: { ...written, type, request, name: text(written['name']) ?? 'Attach' } };
  }
  const program = text(written['program']) ?? (open !== undefined && isProgram(open) ? open : undefined);
  if (program === undefined) {
    return {
      ok: false,
      why: 'There is no program to debug: open a script, or say which one by "program" in launch.json.',
    };
  }
  const name = text(written['name']) ?? 'Debug';
  const own = 'robot' in written || 'installation' in written || 'test' in written;
  const chosen = own ? undefined : armFor(program, robot);
  const arm = chosen === undefined ? {} : { robot: chosen };
  return { ok: true, configuration: { ...written, ...arm, type, request, program, name } };
}

/** The port of the robot that somebody wants to attach to. */
export function attachPort(configuration: Written): number | undefined {
  const port = Number(configuration['port']);
  return Number.isInteger(port) && port >= 1 && port <= 65535 ? port : undefined;
}

function text(value: unknown): string | undefined {
  return typeof value === 'string' && value !== '' ? value : undefined;
}
