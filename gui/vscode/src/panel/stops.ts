/** The stops of a debug session, each with the robot as it was. */
import type { RobotReading } from './reading';

export interface Stop {
  readonly number: number;
  /** Why it stopped, as the adapter says. */
  readonly reason: string;
  /** More about it, such as that it is in the past; empty for most. */
  readonly description: string;
  readonly function: string;
  /** From 1; 0 where no text has it. */
  readonly line: number;
  /** A file; empty where there is none. */
  readonly file: string;
  /** Robot time, s. */
  readonly timeS: number;
  readonly reading: RobotReading;
}

const MOST = 200;

export class Stops {
  private stops: readonly Stop[] = [];
  private next = 1;

  get all(): readonly Stop[] {
    return this.stops;
  }

  get last(): Stop | undefined {
    return this.stops[this.stops.length - 1];
  }

  find(number: number): Stop | undefined {
    return this.stops.find((each) => each.number === number);
  }

  clear(): void {
    this.stops = [];
    this.next = 1;
  }

  add(stop: Omit<Stop, 'number'>): Stop {
    const numbered = { ...stop, number: this.next++ };
    this.stops = [...this.stops, numbered].slice(-MOST);
    return numbered;
  }
}
