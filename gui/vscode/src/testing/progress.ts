/** What `pendant test --verbose` tells while it runs: which tests have passed. */

export interface PassedTest {
  readonly file: string;
  readonly name: string;
}

/** Takes the output as it comes, in pieces of any size. */
export class Progress {
  private rest = '';
  private file = '';

  /** The tests that have passed by this piece. */
  take(text: string): PassedTest[] {
    const lines = (this.rest + text).split('\n');
    this.rest = lines.pop() ?? '';
    return lines.flatMap((each) => this.line(plain(each)));
  }

  private line(line: string): PassedTest[] {
    const file = /^[✓✗○] (\S.*?\.script): /.exec(line);
    if (file !== null) {
      this.file = file[1] ?? '';
      return [];
    }
    const test = /^ {2}✓ (test_.*) in \d[^\]"]*$/.exec(line);
    return test === null || this.file === '' ? [] : [{ file: this.file, name: test[1] ?? '' }];
  }
}

/** Without the marks that make colours of it. */
function plain(line: string): string {
  return line.replace(/\u001b\[[0-9;]*m/g, '').replace(/\r$/, '');
}
