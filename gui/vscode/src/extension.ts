/** The extension: puts its parts together. */
import * as vscode from 'vscode';
import { registerCommands } from './commands';
import { registerDebugger } from './debug/debugger';
import { Pendant } from './executable/pendant';
import { RobotPanel, registerPanel } from './panel/panel';
import { LanguageServer } from './server/client';
import { Status } from './server/status';
import { Tasks } from './tasks/tasks';
import { TestExplorer } from './testing/explorer';

let server: LanguageServer | undefined;

export function activate(context: vscode.ExtensionContext): void {
  const log = vscode.window.createOutputChannel('Pendant', { log: true });
  const pendant = new Pendant(context.extensionPath, log);
  server = new LanguageServer(pendant);
  const status = new Status(server);
  const tasks = new Tasks(pendant);
  const tests = new TestExplorer(pendant);
  context.subscriptions.push(
    log,
    server,
    status,
    tests,
    vscode.tasks.registerTaskProvider('pendant', tasks),
    ...registerDebugger(pendant),
    ...registerPanel(new RobotPanel(context.extensionUri, log)),
    ...registerCommands({ pendant, server, status, tasks, tests, log }),
    vscode.workspace.onDidChangeConfiguration(async (event) => {
      if (event.affectsConfiguration('pendant.path')) {
        await server?.restart();
      }
    }),
  );
  // Not waited for: commands work while it starts.
  void server.start();
}

export async function deactivate(): Promise<void> {
  await server?.stop();
}
