/** Debugs tests: each in a debug session of its own. */
import { randomUUID } from 'node:crypto';
import type { DebugProtocol } from '@vscode/debugprotocol';
import * as vscode from 'vscode';

const TYPE = 'pendant';
/** By which a session knows the wish that it was started for. */
const KEY = 'pendantTestRun';

export interface DebuggedTest {
  readonly uri: vscode.Uri;
  /** With its case. */
  readonly name: string;
  /** Options of `pendant test`. */
  readonly arguments: readonly string[];
  /** Whether it stops once more when it has ended; undefined as the settings say. */
  readonly stopAtEnd: boolean | undefined;
}

/** What came of a test. */
export interface DebugOutcome {
  /** 0 for a green one; undefined where it has not come to its end. */
  readonly exitCode: number | undefined;
  /** What was wrong. */
  readonly message: string;
}

export class TestDebugging implements vscode.Disposable {
  private readonly outcomes = new Map<string, DebugOutcome>();
  private readonly tracker = vscode.debug.registerDebugAdapterTrackerFactory(TYPE, {
    createDebugAdapterTracker: (session) => {
      const key: unknown = session.configuration[KEY];
      return typeof key === 'string' ? { onDidSendMessage: (message) => this.hear(key, message) } : undefined;
    },
  });

  dispose(): void {
    this.tracker.dispose();
  }

  /** Debugs a test, to the end of its session. */
  async debug(test: DebuggedTest, token: vscode.CancellationToken): Promise<DebugOutcome> {
    const key = randomUUID();
    const over = new Promise<void>((resolve) => {
      const listener = vscode.debug.onDidTerminateDebugSession((session) => {
        if (session.configuration[KEY] === key) {
          listener.dispose();
          resolve();
        }
      });
    });
    const started = vscode.debug.onDidStartDebugSession((session) => {
      if (session.configuration[KEY] === key) {
        token.onCancellationRequested(() => vscode.debug.stopDebugging(session));
      }
    });
    try {
      const begun = await vscode.debug.startDebugging(vscode.workspace.getWorkspaceFolder(test.uri), {
        type: TYPE,
        request: 'launch',
        name: test.name,
        program: test.uri.fsPath,
        test: test.name,
        args: test.arguments,
        ...(test.stopAtEnd === undefined ? {} : { stopAtEnd: test.stopAtEnd }),
        [KEY]: key,
      });
      if (begun) {
        await over;
      }
      return this.outcomes.get(key) ?? { exitCode: undefined, message: 'It was not debugged to its end.' };
    } finally {
      started.dispose();
      this.outcomes.delete(key);
    }
  }

  private hear(key: string, message: DebugProtocol.ProtocolMessage): void {
    const event = message as DebugProtocol.Event;
    if (message.type !== 'event') {
      return;
    }
    const known = this.outcomes.get(key) ?? { exitCode: undefined, message: '' };
    if (event.event === 'exited') {
      const { exitCode } = event.body as DebugProtocol.ExitedEvent['body'];
      this.outcomes.set(key, { ...known, exitCode });
    } else if (event.event === 'output') {
      const { category, output } = event.body as DebugProtocol.OutputEvent['body'];
      if (category === 'stderr') {
        this.outcomes.set(key, { ...known, message: known.message + output });
      }
    }
  }
}

/** Debugs tests of the explorer, one after the other, and tells what came of each. */
export async function debugItems(
  debugging: TestDebugging,
  run: vscode.TestRun,
  items: readonly vscode.TestItem[],
  token: vscode.CancellationToken,
): Promise<void> {
  items.forEach((each) => run.enqueued(each));
  for (const item of items) {
    if (item.uri === undefined || token.isCancellationRequested) {
      run.skipped(item);
      continue;
    }
    run.started(item);
    const { exitCode, message } = await debugging.debug(
      {
        uri: item.uri,
        name: item.id,
        arguments: vscode.workspace.getConfiguration('pendant', item.uri).get<string[]>('test.arguments', []),
        // Of several nobody wants to end each by hand.
        stopAtEnd: items.length > 1 ? false : undefined,
      },
      token,
    );
    if (exitCode === 0) {
      run.passed(item);
    } else if (exitCode === undefined) {
      run.skipped(item);
    } else {
      const told = new vscode.TestMessage(message.trim());
      if (item.range !== undefined) {
        told.location = new vscode.Location(item.uri, item.range);
      }
      run.failed(item, told);
    }
  }
  run.end();
}
