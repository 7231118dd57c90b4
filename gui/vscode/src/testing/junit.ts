/** What `pendant test --junit` writes. */
import sax from 'sax';

/** A place in a file; lines and columns count from 0. */
export interface Place {
  /** As Pendant names it, relative to the folder that it ran in. */
  readonly file: string;
  readonly line: number;
  readonly column: number;
}

export interface Call {
  readonly name: string;
  readonly place: Place;
}

export interface TestOutcome {
  readonly file: string;
  /** The function, with its case: `test_grip[0.1, True]`. */
  readonly name: string;
  readonly status: 'passed' | 'failed' | 'error' | 'skipped';
  readonly robotTimeMs: number;
  /** What is wrong, or why it was skipped; empty for passed ones. */
  readonly message: string;
  /** The message with source line and call stack. */
  readonly details: string;
  readonly place: Place | undefined;
  /** Innermost first; empty where the fault is in the test itself. */
  readonly stack: readonly Call[];
  readonly output: string;
}

/** A file of which no test could run. */
export interface BrokenFile {
  readonly file: string;
  readonly message: string;
  readonly place: Place | undefined;
}

export interface TestReport {
  readonly tests: readonly TestOutcome[];
  readonly broken: readonly BrokenFile[];
}

/** The name that stands for a file of which no test could run. */
const FILE_ITSELF = '(the file itself)';

interface Case {
  attributes: Record<string, string>;
  kind: '' | 'skipped' | 'failure' | 'error';
  message: string;
  details: string;
  output: string;
}

/**
 * Reads a report.
 *
 * @throws Error where it is not whole
 */
export function readJunit(xml: string): TestReport {
  const tests: TestOutcome[] = [];
  const broken: BrokenFile[] = [];
  let now: Case | undefined;
  let text = '';
  let ended = false;
  const parser = sax.parser(true);
  parser.onerror = (error) => {
    throw error;
  };
  parser.onopentag = ({ name, attributes }) => {
    const values = attributes as Record<string, string>;
    text = '';
    if (name === 'testcase') {
      now = { attributes: values, kind: '', message: '', details: '', output: '' };
    } else if (now !== undefined && (name === 'failure' || name === 'error' || name === 'skipped')) {
      now.kind = name;
      now.message = values['message'] ?? '';
    }
  };
  parser.ontext = (part) => {
    text += part;
  };
  parser.onclosetag = (name) => {
    if (name === 'testsuites') {
      ended = true;
    }
    if (now === undefined) {
      return;
    }
    if (name === 'failure' || name === 'error') {
      now.details = text;
    } else if (name === 'system-out') {
      now.output = text;
    } else if (name === 'testcase') {
      if (now.attributes['name'] === FILE_ITSELF) {
        broken.push(brokenFile(now));
      } else {
        tests.push(outcome(now));
      }
      now = undefined;
    }
  };
  parser.write(xml).close();
  if (!ended) {
    throw new Error('the report of the tests is not whole');
  }
  return { tests, broken };
}

function outcome(read: Case): TestOutcome {
  const file = read.attributes['file'] ?? '';
  const lines = read.details.split('\n');
  return {
    file,
    name: read.attributes['name'] ?? '',
    status: read.kind === '' ? 'passed' : read.kind === 'failure' ? 'failed' : read.kind,
    robotTimeMs: 1000 * Number(read.attributes['time'] ?? 0),
    message: read.message,
    details: read.details,
    place: errorPlace(lines) ?? ownPlace(file, read),
    stack: lines.flatMap((each) => call(each) ?? []),
    output: read.output,
  };
}

function brokenFile(read: Case): BrokenFile {
  const place = errorPlace(read.details.split('\n'));
  return { file: read.attributes['file'] ?? '', message: read.details || read.message, place };
}

function ownPlace(file: string, read: Case): Place | undefined {
  const line = Number(read.attributes['line']);
  return line > 0 ? { file, line: line - 1, column: 0 } : undefined;
}

/** The place in the first line that has the form of an error. */
function errorPlace(lines: readonly string[]): Place | undefined {
  for (const each of lines) {
    const match = /^(\S.*?):(\d+)(?::(\d+))?: error: /.exec(each);
    if (match !== null) {
      return place(match[1], match[2], match[3]);
    }
  }
  return undefined;
}

function call(line: string): Call | undefined {
  const match = /^ {2}(?:in (.+?), |at )(\S.*?):(\d+):(\d+)$/.exec(line);
  return match === null ? undefined : { name: match[1] ?? '', place: place(match[2], match[3], match[4]) };
}

function place(file: string | undefined, line: string | undefined, column: string | undefined): Place {
  return { file: file ?? '', line: Number(line) - 1, column: Number(column ?? 1) - 1 };
}
