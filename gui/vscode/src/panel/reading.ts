/** What a debug session tells of its robot at a stop: the scopes Robot and I/O, read from their texts. */

/** As the debug adapter protocol has them. */
export interface Variable {
  readonly name: string;
  readonly value: string;
}

/** Digital signals that stand beside each other. */
export interface Bank {
  /** Such as `digital_out`. */
  readonly name: string;
  readonly on: readonly boolean[];
}

export interface Fact {
  readonly name: string;
  readonly value: string;
}

export interface RobotReading {
  /** Which arm is drawn. */
  readonly arm: string;
  readonly time: string;
  /** Modes and what stopped it. */
  readonly facts: readonly Fact[];
  /** Positions of the joints, rad; empty where they are not told. */
  readonly joints: readonly number[];
  /** Pose of the TCP in the base frame, m and rad; empty where it is not told. */
  readonly tcp: readonly number[];
  readonly banks: readonly Bank[];
  readonly analog: readonly Fact[];
}

const BANKS = ['digital_in', 'digital_out', 'configurable_in', 'configurable_out', 'tool_in', 'tool_out'];
const ANALOG = ['analog_in', 'analog_out', 'tool_analog_in'];
const FACTS = ['robot_mode', 'safety_mode', 'safety_stop', 'tcp_speed', 'tcp_force', 'speed_slider', 'payload'];

/** @param arm which arm it is, as `--robot` names it */
export function read(arm: string, robot: readonly Variable[], signals: readonly Variable[]): RobotReading {
  const value = (of: readonly Variable[], name: string) => of.find((each) => each.name === name)?.value;
  return {
    arm,
    time: value(robot, 'time') ?? '',
    facts: FACTS.flatMap((name) => {
      const told = value(robot, name);
      return told === undefined ? [] : [{ name, value: told }];
    }),
    joints: six(value(robot, 'actual_q')),
    tcp: six(value(robot, 'actual_tcp')),
    banks: BANKS.flatMap((name) => {
      const on = levels(value(signals, name));
      return on.length === 0 ? [] : [{ name, on }];
    }),
    analog: ANALOG.flatMap((name) => {
      const told = value(signals, name);
      return told === undefined ? [] : [{ name, value: told }];
    }),
  };
}

/** The elements of a list as it is shown: `[0, -1.57, ...]`. */
function elements(text: string | undefined): string[] {
  const inside = /^p?\[(.*)\]$/.exec(text?.trim() ?? '')?.[1];
  return inside === undefined || inside.trim() === '' ? [] : inside.split(',').map((each) => each.trim());
}

function six(text: string | undefined): number[] {
  const numbers = elements(text).map(Number);
  return numbers.length === 6 && numbers.every(Number.isFinite) ? numbers : [];
}

function levels(text: string | undefined): boolean[] {
  const all = elements(text);
  return all.every((each) => each === 'True' || each === 'False') ? all.map((each) => each === 'True') : [];
}
