/** What `pendant test` is told to run. */

/** A test that somebody wants; without a name all tests of the file. */
export interface Wanted {
  /** Relative to the folder that Pendant runs in. */
  readonly file: string;
  readonly name: string | undefined;
}

/** Arguments that run what is wanted; they may run more, as a filter is a part of a name. */
export function selection(wanted: readonly Wanted[]): string[] {
  const files = [...new Set(wanted.map((each) => each.file))];
  const whole = new Set(wanted.filter((each) => each.name === undefined).map((each) => each.file));
  const named = wanted.filter((each) => each.name !== undefined && !whole.has(each.file));
  if (named.length === 0) {
    return ['--', ...files];
  }
  const filters = [
    ...named.map((each) => `${each.file}:${each.name}`),
    ...[...whole].map((file) => `${file}:`),
  ];
  return [...filters.flatMap((each) => ['--filter', each]), '--', ...files];
}

/** The function of a test, without its case: `test_grip` for `test_grip[0.1, True]`. */
export function functionOf(test: string): string {
  const bracket = test.indexOf('[');
  return bracket < 0 ? test : test.slice(0, bracket);
}
