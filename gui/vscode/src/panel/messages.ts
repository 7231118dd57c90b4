/** What the panel and its page tell each other. */
import type { LogLine, Timeline } from './live';
import type { RobotReading } from './reading';
import type { Stop } from './stops';

/** `past`: the program is stopped, and a moment of its recording is looked at. */
export type State = 'none' | 'running' | 'stopped' | 'past' | 'ended';

/** To the page. */
export interface Show {
  readonly kind: 'show';
  readonly state: State;
  readonly stops: readonly Stop[];
  /** The robot at the moment that is looked at; undefined before the first is known. */
  readonly now: RobotReading | undefined;
  readonly timeline: Timeline | undefined;
  /** The newest lines of output, the oldest first. */
  readonly log: readonly LogLine[];
}

export type Step = 'back' | 'on' | 'moveBack' | 'moveOn';

/** From the page. */
export type Wish =
  | { readonly kind: 'ready' }
  | { readonly kind: 'open'; readonly stop: number }
  | { readonly kind: 'signal'; readonly bank: string; readonly index: number; readonly on: boolean }
  /** Looks at a time; `stay` where the debugger is to go there, too. */
  | { readonly kind: 'time'; readonly timeS: number; readonly stay: boolean }
  /** Looks at the robot as it is now. */
  | { readonly kind: 'now' }
  | { readonly kind: 'step'; readonly step: Step }
  | { readonly kind: 'moment'; readonly id: number };
