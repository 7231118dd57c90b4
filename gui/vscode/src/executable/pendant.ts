/** The `pendant` command of this computer, and what is said where there is none. */
import * as fs from 'node:fs';
import * as os from 'node:os';
import * as vscode from 'vscode';
import { search, type Search } from './search';

export class Pendant {
  private told = false;

  constructor(
    private readonly extension: string,
    private readonly log: vscode.LogOutputChannel,
  ) {}

  /** Looks for it anew. */
  look(): Search {
    const result = search({
      platform: process.platform,
      home: os.homedir(),
      searchPath: process.env['PATH'] ?? '',
      setting: vscode.workspace.getConfiguration('pendant').get<string>('path', ''),
      folder: vscode.workspace.workspaceFolders?.[0]?.uri.fsPath,
      extension: this.extension,
      isProgram,
      isFolder,
    });
    void vscode.commands.executeCommand('setContext', 'pendant.found', result.found);
    if (result.found) {
      this.log.info(`pendant is ${result.file} (${result.by})`);
    } else {
      this.log.warn([result.why, 'Looked in:', ...result.looked.map((each) => `  ${each}`)].join('\n'));
    }
    return result;
  }

  /** The command, for something that somebody has asked for: where there is none, this says so each time. */
  demand(): string | undefined {
    if (!vscode.workspace.isTrusted) {
      void vscode.window.showErrorMessage('Programs and tests run in trusted folders only.');
      return undefined;
    }
    const result = this.look();
    if (result.found) {
      return result.file;
    }
    void this.explain(result.why);
    return undefined;
  }

  /** The command, for something that begins by itself: that there is none is said once. */
  offer(): string | undefined {
    const result = this.look();
    if (result.found) {
      this.told = false;
      return result.file;
    }
    if (!this.told) {
      this.told = true;
      void this.explain(result.why);
    }
    return undefined;
  }

  private async explain(why: string): Promise<void> {
    const choose = 'Choose...';
    const help = 'How to Get It';
    const details = 'Show Where';
    const answer = await vscode.window.showErrorMessage(
      `${why} Without it URScript has colours only.`,
      choose,
      help,
      details,
    );
    if (answer === choose) {
      await this.choose();
    } else if (answer === help) {
      await vscode.commands.executeCommand('workbench.action.openWalkthrough', 'pendant.pendant-urscript#start', false);
    } else if (answer === details) {
      this.log.show();
    }
  }

  /** Lets people choose it, and writes that into the setting. */
  async choose(): Promise<void> {
    const chosen = await vscode.window.showOpenDialog({
      title: 'The pendant command, or the folder that it is in',
      openLabel: 'Use',
      canSelectFiles: true,
      canSelectFolders: true,
    });
    const file = chosen?.[0];
    if (file !== undefined) {
      await vscode.workspace
        .getConfiguration('pendant')
        .update('path', file.fsPath, vscode.ConfigurationTarget.Global);
    }
  }
}

function isProgram(file: string): boolean {
  try {
    fs.accessSync(file, fs.constants.X_OK);
    return fs.statSync(file).isFile();
  } catch {
    return false;
  }
}

function isFolder(file: string): boolean {
  try {
    return fs.statSync(file).isDirectory();
  } catch {
    return false;
  }
}
