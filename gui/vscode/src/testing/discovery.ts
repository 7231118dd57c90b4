/** Tests in the text of a file: functions `test_...`, with the marks above them. */

/** A test; lines and columns count from 0. */
export interface FoundTest {
  readonly name: string;
  readonly line: number;
  readonly column: number;
  readonly tags: readonly string[];
  /** The arguments of its cases, each once, as they are written. */
  readonly cases: readonly string[];
  /** Why it is not run, if it is not. */
  readonly skipped: string | undefined;
}

const NAME = /_test\.script$/;
// `def` may stand in the middle of a line, where another block ends; a test there is not worth the search.
const DEFINITION = /^(\s*def\s+)(test_\w*)\s*\(/;
const OPENING = /(?:^|[^.\w])(def|sec|thread|if|while)\b/g;
const CLOSING = /(?:^|[^.\w])end\b/g;

/** Whether a file by this name holds tests. */
export function holdsTests(file: string): boolean {
  return NAME.test(file);
}

/** The tests of a text, from top to bottom. */
export function discover(text: string): FoundTest[] {
  const tests: FoundTest[] = [];
  let above: string[] = [];
  let depth = 0;
  for (const [line, whole] of text.split(/\r\n|\r|\n/).entries()) {
    const comment = /^\s*#(.*)$/.exec(whole);
    if (comment !== null) {
      above.push(comment[1] ?? '');
      continue;
    }
    const definition = DEFINITION.exec(whole);
    if (definition !== null && depth === 0) {
      tests.push({
        name: definition[2] ?? '',
        line,
        column: (definition[1] ?? '').length,
        tags: marked(above, 'tag').flatMap((each) => each.split(',').map((tag) => tag.trim())).filter((tag) => tag !== ''),
        cases: [...new Set(marked(above, 'case').filter((each) => each !== ''))],
        skipped: marked(above, 'skip')[0],
      });
    }
    above = [];
    const code = withoutTexts(whole);
    depth = Math.max(0, depth + count(code, OPENING) - count(code, CLOSING));
  }
  return tests;
}

function marked(comments: readonly string[], mark: string): string[] {
  const form = new RegExp(`^\\s*@${mark}\\b\\s*(.*?)\\s*$`);
  return comments.flatMap((each) => form.exec(each)?.[1] ?? []);
}

/** Without strings and what a comment says: words in them open no blocks. */
function withoutTexts(line: string): string {
  return line.replace(/"[^"]*"?|#.*$/g, ' ');
}

function count(text: string, form: RegExp): number {
  return text.match(form)?.length ?? 0;
}
