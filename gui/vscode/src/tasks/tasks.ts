/** Tasks: check, test and run, in the terminal, with mistakes in the list of problems. */
import * as path from 'node:path';
import * as vscode from 'vscode';
import { armFor } from '../debug/configuration';
import type { Pendant } from '../executable/pendant';
import { chosenRobot } from '../settings';

const TYPE = 'pendant';
const MATCHER = '$pendant';

interface Definition extends vscode.TaskDefinition {
  readonly command: 'check' | 'test' | 'run';
  readonly arguments?: readonly string[];
}

export class Tasks implements vscode.TaskProvider {
  constructor(private readonly pendant: Pendant) {}

  provideTasks(): vscode.Task[] {
    const folder = vscode.workspace.workspaceFolders?.[0];
    const search = this.pendant.look();
    if (folder === undefined || !search.found) {
      return [];
    }
    return [
      task(search.file, folder, 'check the open file', { type: TYPE, command: 'check', arguments: ['${file}'] }),
      task(search.file, folder, 'run the open file', { type: TYPE, command: 'run', arguments: ['${file}'] }),
      task(search.file, folder, 'test all', { type: TYPE, command: 'test' }),
    ];
  }

  resolveTask(written: vscode.Task): vscode.Task | undefined {
    const definition = written.definition as Definition;
    const search = this.pendant.look();
    const folder = typeof written.scope === 'object' ? written.scope : vscode.workspace.workspaceFolders?.[0];
    if (!search.found || folder === undefined) {
      return undefined;
    }
    return task(search.file, folder, written.name, definition);
  }

  /** Runs a program in the terminal. */
  async run(program: vscode.Uri): Promise<void> {
    const command = this.pendant.demand();
    if (command === undefined) {
      return;
    }
    const folder = vscode.workspace.getWorkspaceFolder(program);
    const cwd = folder?.uri.fsPath ?? path.dirname(program.fsPath);
    const name = path.relative(cwd, program.fsPath);
    const robot = armFor(program.fsPath, chosenRobot(program));
    const options = robot === undefined ? [] : [`--robot=${robot}`];
    // After -- everything is a file, whatever it begins with.
    const definition: Definition = { type: TYPE, command: 'run', arguments: [...options, '--', name] };
    await vscode.tasks.executeTask(task(command, folder ?? vscode.TaskScope.Workspace, `run ${name}`, definition, cwd));
  }
}

function task(
  command: string,
  scope: vscode.WorkspaceFolder | vscode.TaskScope.Workspace,
  name: string,
  definition: Definition,
  cwd = typeof scope === 'object' ? scope.uri.fsPath : undefined,
): vscode.Task {
  const execution = new vscode.ProcessExecution(
    command,
    [definition.command, ...(definition.arguments ?? [])],
    cwd === undefined ? {} : { cwd },
  );
  const made = new vscode.Task(definition, scope, name, TYPE, execution, MATCHER);
  if (definition.command !== 'run') {
    made.group = definition.command === 'test' ? vscode.TaskGroup.Test : vscode.TaskGroup.Build;
  }
  made.presentationOptions = {
    reveal: vscode.TaskRevealKind.Always,
    panel: vscode.TaskPanelKind.Dedicated,
    clear: true,
    focus: false,
    showReuseMessage: false,
  };
  return made;
}
