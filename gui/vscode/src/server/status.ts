/** The item in the status bar: whether the language server runs, and a menu. */
import * as vscode from 'vscode';
import type { LanguageServer, ServerState } from './client';

export class Status implements vscode.Disposable {
  private readonly item = vscode.window.createStatusBarItem('pendant', vscode.StatusBarAlignment.Right, 90);
  private readonly subscriptions: vscode.Disposable[];

  constructor(private readonly server: LanguageServer) {
    this.item.name = 'Pendant';
    this.item.command = 'pendant.menu';
    this.subscriptions = [
      server.onDidChange(() => this.show()),
      vscode.window.onDidChangeActiveTextEditor(() => this.show()),
    ];
    this.show();
  }

  dispose(): void {
    this.item.dispose();
    this.subscriptions.forEach((each) => each.dispose());
  }

  /** What one can do about it. */
  async menu(): Promise<void> {
    const entries = [
      { label: '$(refresh) Restart language server', command: 'pendant.restart' },
      { label: '$(output) Show output', command: 'pendant.showOutput' },
      { label: '$(folder-opened) Choose the pendant command...', command: 'pendant.choose' },
      { label: '$(settings-gear) Settings', command: 'workbench.action.openSettings', argument: '@ext:pendant.pendant-urscript' },
    ];
    const chosen = await vscode.window.showQuickPick(entries, { placeHolder: words(this.server.state).tooltip });
    if (chosen !== undefined) {
      await vscode.commands.executeCommand(chosen.command, ...(chosen.argument === undefined ? [] : [chosen.argument]));
    }
  }

  private show(): void {
    const state = this.server.state;
    const { text, tooltip } = words(state);
    this.item.text = text;
    this.item.tooltip = tooltip;
    const bad = state.kind === 'missing' || state.kind === 'failed';
    this.item.backgroundColor = bad ? new vscode.ThemeColor('statusBarItem.errorBackground') : undefined;
    const language = vscode.window.activeTextEditor?.document.languageId;
    if (bad || language === 'urscript' || language === 'pendant-tree') {
      this.item.show();
    } else {
      this.item.hide();
    }
  }
}

function words(state: ServerState): { text: string; tooltip: string } {
  switch (state.kind) {
    case 'off':
      return { text: '$(circle-slash) Pendant', tooltip: 'The language server does not run.' };
    case 'starting':
      return { text: '$(sync~spin) Pendant', tooltip: 'The language server is starting.' };
    case 'running':
      return { text: '$(check) Pendant', tooltip: `Pendant ${state.version}`.trim() + ': the language server runs.' };
    case 'missing':
      return { text: '$(error) Pendant', tooltip: 'The command pendant was not found.' };
    case 'failed':
      return { text: '$(error) Pendant', tooltip: state.why };
  }
}
