/** The debugger: `pendant dap` for VS Code's own debug views, also without a launch.json. */
import * as vscode from 'vscode';
import type { Pendant } from '../executable/pendant';
import { chosenRobot, stopsAtEnd } from '../settings';
import { attachPort, complete, isProgram } from './configuration';

const TYPE = 'pendant';

export function registerDebugger(pendant: Pendant): vscode.Disposable[] {
  return [
    vscode.debug.registerDebugConfigurationProvider(TYPE, new Configurations()),
    vscode.debug.registerDebugConfigurationProvider(
      TYPE,
      { provideDebugConfigurations: () => offered(openFile()) },
      vscode.DebugConfigurationProviderTriggerKind.Dynamic,
    ),
    vscode.debug.registerDebugAdapterDescriptorFactory(TYPE, new Adapters(pendant)),
  ];
}

/** Debugs a program, or runs it without stopping anywhere. */
export async function debugProgram(program: vscode.Uri, noDebug = false): Promise<void> {
  const folder = vscode.workspace.getWorkspaceFolder(program);
  const name = vscode.workspace.asRelativePath(program, false);
  await vscode.debug.startDebugging(
    folder,
    { type: TYPE, request: 'launch', name, program: program.fsPath },
    { noDebug },
  );
}

class Configurations implements vscode.DebugConfigurationProvider {
  provideDebugConfigurations(): vscode.DebugConfiguration[] {
    return [{ type: TYPE, request: 'launch', name: 'Debug the open program', program: '${file}' }];
  }

  resolveDebugConfiguration(
    folder: vscode.WorkspaceFolder | undefined,
    written: vscode.DebugConfiguration,
  ): vscode.ProviderResult<vscode.DebugConfiguration> {
    const completed = complete(written, openFile(), chosenRobot(folder?.uri));
    if (completed.ok) {
      const { configuration } = completed;
      return configuration.request === 'launch'
        ? { stopAtEnd: stopsAtEnd(folder?.uri), ...configuration }
        : configuration;
    }
    void vscode.window.showErrorMessage(completed.why);
    return undefined;
  }
}

class Adapters implements vscode.DebugAdapterDescriptorFactory {
  constructor(private readonly pendant: Pendant) {}

  createDebugAdapterDescriptor(session: vscode.DebugSession): vscode.ProviderResult<vscode.DebugAdapterDescriptor> {
    const port = attachPort(session.configuration);
    if (session.configuration.request === 'attach' && port !== undefined) {
      return new vscode.DebugAdapterServer(port, '127.0.0.1');
    }
    const command = this.pendant.demand();
    if (command === undefined) {
      // Ends the session; what is missing has been said.
      throw new Error('The command pendant was not found.');
    }
    const cwd = session.workspaceFolder?.uri.fsPath;
    return new vscode.DebugAdapterExecutable(command, ['dap'], cwd === undefined ? {} : { cwd });
  }
}

function offered(open: string | undefined): vscode.DebugConfiguration[] {
  if (open === undefined || !isProgram(open)) {
    return [];
  }
  return [{ type: TYPE, request: 'launch', name: `Debug ${vscode.workspace.asRelativePath(open)}`, program: open }];
}

function openFile(): string | undefined {
  const document = vscode.window.activeTextEditor?.document;
  return document?.uri.scheme === 'file' ? document.uri.fsPath : undefined;
}
