/** Follows the robot of a debug session: at its stops, and while its program runs. */
import * as vscode from 'vscode';
import type { DebugProtocol } from '@vscode/debugprotocol';
import { appended, readingOf, timelineOf, type LogLine, type RobotAnswer, type Timeline } from './live';
import type { State, Step } from './messages';
import { fileOf } from './place';
import type { RobotReading } from './reading';
import { Stops } from './stops';

/** A picture ten times a second is enough for people, and costs the robot nothing. */
const PERIOD_MS = 100;

export class Follower {
  readonly stops = new Stops();
  state: State = 'running';
  now: RobotReading | undefined;
  timeline: Timeline | undefined;
  log: readonly LogLine[] = [];
  private thread = 1;
  /** A time that people look at while the program goes on; undefined for now. */
  private looked: number | undefined;
  private timer: NodeJS.Timeout | undefined;
  private asking = false;
  /** Counts stops and goings-on: what was asked before the last one is old. */
  private turns = 0;

  /**
   * @param changed hears that there is something else to show
   * @param visible whether anybody sees it
   */
  constructor(
    readonly session: vscode.DebugSession,
    private readonly changed: () => void,
    private readonly visible: () => boolean,
    private readonly warn: (text: string) => void,
  ) {}

  /** Begins to look while the program runs. */
  follow(): void {
    this.timer ??= setInterval(() => {
      if (this.state === 'running' && this.visible() && !this.asking) {
        void this.look();
      }
    }, PERIOD_MS);
  }

  end(): void {
    clearInterval(this.timer);
    this.timer = undefined;
    this.state = 'ended';
    this.changed();
  }

  hear(event: DebugProtocol.Event): void {
    if (event.event === 'stopped') {
      void this.stopped(event.body as DebugProtocol.StoppedEvent['body']);
    } else if (event.event === 'continued') {
      this.continued();
    }
  }

  /** The program goes on. */
  continued(): void {
    if (this.state !== 'ended') {
      this.turns++;
      this.state = 'running';
      this.changed();
    }
  }

  private async stopped({ threadId, reason, description }: DebugProtocol.StoppedEvent['body']): Promise<void> {
    this.thread = threadId ?? 1;
    this.looked = undefined;
    this.turns++;
    this.state = 'stopped';
    try {
      const trace: DebugProtocol.StackTraceResponse['body'] = await this.session.customRequest('stackTrace', {
        threadId: this.thread,
        startFrame: 0,
        levels: 1,
      });
      await this.look();
      const frame = trace.stackFrames[0];
      if (frame !== undefined && this.now !== undefined) {
        this.stops.add({
          reason,
          description: description ?? '',
          function: frame.name,
          line: frame.line,
          file: fileOf(frame.source?.path) ?? '',
          timeS: this.timeline?.atS ?? 0,
          reading: this.now,
        });
        this.changed();
      }
    } catch (error) {
      this.warn(String(error));
    }
  }

  /** Asks what there is to be seen now. */
  async look(): Promise<void> {
    this.asking = true;
    const turn = this.turns;
    try {
      const asked = this.looked === undefined ? {} : { timeS: this.looked };
      const answer: RobotAnswer = await this.session.customRequest('pendant/robot', asked);
      const lines: { moments: LogLine[] } = await this.session.customRequest('pendant/moments', {
        after: this.log[this.log.length - 1]?.id ?? 0,
      });
      if (this.state === 'ended' || turn !== this.turns) {
        return;
      }
      this.now = readingOf(answer);
      this.timeline = timelineOf(answer);
      this.log = appended(this.log, lines.moments);
      if (this.looked === undefined && this.state !== 'running') {
        this.state = answer.state;
      }
      this.changed();
    } catch (error) {
      // the session may just have ended
      this.warn(String(error));
    } finally {
      this.asking = false;
    }
  }

  /** Looks at another time; with `stay` the debugger goes there, too, if the program is stopped. */
  async lookAt(timeS: number, stay: boolean): Promise<void> {
    this.looked = timeS;
    if (stay && this.state !== 'running') {
      await this.session.customRequest('pendant/goToTime', { timeS });
    } else if (!this.asking) {
      await this.look();
    }
  }

  /** Looks at now again. */
  async lookAtNow(): Promise<void> {
    this.looked = undefined;
    if (this.state === 'past' && this.timeline !== undefined) {
      await this.session.customRequest('pendant/goToTime', { timeS: this.timeline.nowS });
    } else {
      await this.look();
    }
  }

  async step(step: Step): Promise<void> {
    const threadId = this.thread;
    switch (step) {
      case 'back':
        await this.session.customRequest('stepBack', { threadId });
        break;
      case 'on':
        await this.session.customRequest('next', { threadId });
        break;
      case 'moveBack':
      case 'moveOn':
        await this.session.customRequest('pendant/stepToMove', { threadId, back: step === 'moveBack' });
        break;
    }
  }

  async goToMoment(id: number): Promise<void> {
    await this.session.customRequest('pendant/goToMoment', { id });
  }

  async setSignal(bank: string, index: number, on: boolean): Promise<void> {
    try {
      await this.session.customRequest('pendant/setSignal', { bank, index, on });
    } finally {
      await this.look();
    }
  }
}
