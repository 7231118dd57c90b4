/** Steps from move to move, and from lines of output back to their moments. */
import * as vscode from 'vscode';
import type { LogLine } from '../panel/live';
import { offers } from './moments';

const TYPE = 'pendant';

export const pastCommands: { readonly [name: string]: (...args: never[]) => unknown } = {
  'pendant.stepToMove': () => stepToMove(false),
  'pendant.stepBackToMove': () => stepToMove(true),
  'pendant.goToMoment': () => goToMoment(undefined),
  'pendant.goToMomentOfLine': () => goToMoment(vscode.window.activeTextEditor),
};

/** The session that people look at, if it is one of ours. */
function session(): vscode.DebugSession | undefined {
  const active = vscode.debug.activeDebugSession;
  if (active?.type !== TYPE) {
    void vscode.window.showErrorMessage('Debug a program of a robot first.');
    return undefined;
  }
  return active;
}

async function stepToMove(back: boolean): Promise<void> {
  const item = vscode.debug.activeStackItem;
  const threadId = item instanceof vscode.DebugStackFrame || item instanceof vscode.DebugThread ? item.threadId : 1;
  await ask(session(), 'pendant/stepToMove', { threadId, back });
}

/** @param editor whose line is meant; undefined for all lines of output */
async function goToMoment(editor: vscode.TextEditor | undefined): Promise<void> {
  const active = session();
  const answer = await ask<{ moments: LogLine[] }>(active, 'pendant/moments', {});
  if (active === undefined || answer === undefined) {
    return;
  }
  const line = editor === undefined ? undefined : editor.selection.active.line + 1;
  const offered = offers(answer.moments, line);
  if (offered.length === 0) {
    const what = line === undefined ? 'Nothing has' : `Line ${line} has not`;
    void vscode.window.showInformationMessage(`${what} written any output yet.`);
    return;
  }
  const [only] = offered;
  const chosen =
    line !== undefined && offered.length === 1
      ? only
      : await vscode.window.showQuickPick(offered, {
          title: 'Go to the moment this was written',
          placeHolder: 'A line of output',
          matchOnDescription: true,
        });
  if (chosen !== undefined) {
    await ask(active, 'pendant/goToMoment', { id: chosen.id });
  }
}

/** Asks the adapter; a refusal is told. */
async function ask<T>(of: vscode.DebugSession | undefined, request: string, told: object): Promise<T | undefined> {
  try {
    return await of?.customRequest(request, told);
  } catch (error) {
    void vscode.window.showErrorMessage(error instanceof Error ? error.message : String(error));
    return undefined;
  }
}
