/** Lines of output, as they are offered to people. */
import type { LogLine } from '../panel/live';

export interface Offer {
  readonly label: string;
  readonly description: string;
  readonly id: number;
}

/**
 * The newest first.
 *
 * @param line of the program that has written them; undefined for any
 */
export function offers(lines: readonly LogLine[], line: number | undefined): Offer[] {
  return lines
    .filter((each) => line === undefined || each.line === line)
    .map(({ id, timeS, text, line: by }) => ({
      label: text === '' ? '(an empty line)' : text,
      description: by === undefined ? `${timeS.toFixed(3)} s` : `${timeS.toFixed(3)} s, line ${by}`,
      id,
    }))
    .reverse();
}
