/** What `pendant test --lcov` writes. */

/** One of the two ways that a condition can go; `count` is how many tests went it. */
export interface Branch {
  readonly line: number;
  readonly label: string;
  readonly count: number;
}

/** What was reached of a file; lines count from 0. */
export interface FileReach {
  readonly file: string;
  readonly lines: readonly { readonly line: number; readonly count: number }[];
  readonly branches: readonly Branch[];
  readonly functions: readonly { readonly name: string; readonly line: number; readonly count: number }[];
}

/** Reads a report; lines of other kinds are left out. */
export function readLcov(text: string): FileReach[] {
  const files: FileReach[] = [];
  let file = '';
  let lines: { line: number; count: number }[] = [];
  let branches: Branch[] = [];
  let functions = new Map<string, { name: string; line: number; count: number }>();
  for (const each of text.split(/\r?\n/)) {
    const colon = each.indexOf(':');
    const kind = colon < 0 ? each : each.slice(0, colon);
    const rest = each.slice(colon + 1);
    const parts = rest.split(',');
    switch (kind) {
      case 'SF':
        file = rest;
        lines = [];
        branches = [];
        functions = new Map();
        break;
      case 'DA':
        lines.push({ line: Number(parts[0]) - 1, count: Number(parts[1]) });
        break;
      case 'BRDA':
        branches.push({
          line: Number(parts[0]) - 1,
          label: parts[2] === '0' ? 'condition is True' : 'condition is False',
          count: parts[3] === '-' ? 0 : Number(parts[3]),
        });
        break;
      case 'FN': {
        const name = parts[parts.length - 1] ?? '';
        functions.set(name, { name, line: Number(parts[0]) - 1, count: 0 });
        break;
      }
      case 'FNDA': {
        const known = functions.get(parts[1] ?? '');
        if (known !== undefined) {
          known.count = Number(parts[0]);
        }
        break;
      }
      case 'end_of_record':
        files.push({ file, lines, branches, functions: [...functions.values()] });
        break;
      default:
    }
  }
  return files;
}
