/** Settings that several parts read. */
import * as vscode from 'vscode';

/** Whether programs stop once more when they have ended. */
export function stopsAtEnd(scope: vscode.Uri | undefined): boolean {
  return vscode.workspace.getConfiguration('pendant', scope).get<boolean>('debug.stopAtEnd', true);
}

/** The arm that people have chosen; undefined where none of their settings names one. */
export function chosenRobot(scope: vscode.Uri | undefined): string | undefined {
  const found = vscode.workspace.getConfiguration('pendant', scope).inspect<string>('robot');
  return found?.workspaceFolderValue ?? found?.workspaceValue ?? found?.globalValue;
}
