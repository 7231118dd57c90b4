/** What the adapter tells of a robot beyond the protocol: `pendant/robot` and `pendant/moments`. */
import { read, type RobotReading, type Variable } from './reading';

/** The answer to `pendant/robot`. */
export interface RobotAnswer {
  readonly state: 'running' | 'stopped' | 'past' | 'ended';
  readonly arm: string;
  readonly timeS: number;
  /** What the recording has, robot time in s. */
  readonly fromS: number;
  readonly nowS: number;
  readonly robot: readonly Variable[];
  readonly signals: readonly Variable[];
}

/** Robot times, s. */
export interface Timeline {
  readonly fromS: number;
  readonly nowS: number;
  readonly atS: number;
}

/** A line of output. */
export interface LogLine {
  readonly id: number;
  readonly timeS: number;
  /** From 1; absent where no line of a program wrote it. */
  readonly line?: number;
  readonly text: string;
}

const MOST_LINES = 500;

export function readingOf(answer: RobotAnswer): RobotReading {
  return read(answer.arm, answer.robot, answer.signals);
}

export function timelineOf({ fromS, nowS, timeS }: RobotAnswer): Timeline {
  return { fromS, nowS: Math.max(fromS, nowS), atS: Math.min(Math.max(timeS, fromS), Math.max(fromS, nowS)) };
}

/** The newest lines, with those that have come; what is known already is not doubled. */
export function appended(known: readonly LogLine[], come: readonly LogLine[]): readonly LogLine[] {
  const last = known[known.length - 1]?.id ?? 0;
  const fresh = come.filter((each) => each.id > last);
  return fresh.length === 0 ? known : [...known, ...fresh].slice(-MOST_LINES);
}

/** Where a time is on a line, 0 to 1. */
export function share({ fromS, nowS }: Timeline, timeS: number): number {
  return nowS <= fromS ? 0 : Math.min(1, Math.max(0, (timeS - fromS) / (nowS - fromS)));
}
