/** The commands that people and code lenses call. */
import { spawn } from 'node:child_process';
import * as path from 'node:path';
import * as vscode from 'vscode';
import { debugProgram } from './debug/debugger';
import { pastCommands } from './debug/past';
import type { Pendant } from './executable/pendant';
import type { LanguageServer } from './server/client';
import type { Status } from './server/status';
import type { Tasks } from './tasks/tasks';
import type { TestExplorer } from './testing/explorer';

const PROGRAM = `def first_program():
  textmsg("on my way")
  movej([0, -1.57, -1.57, -1.57, 1.57, 0], a=1.4, v=1.05)
  i = 1
  while i <= 3:
    movel(pose_trans(get_target_tcp_pose(), p[0, 0, 0.05 * i, 0, 0, 0]), a=1.2, v=0.25)
    textmsg("step ", i)
    i = i + 1
  end
  textmsg("arrived at ", get_actual_tcp_pose())
end
`;

const TESTS = `# Tests of robot programs: each test has a robot of its own.

def test_the_arm_arrives():
  target = [0, -1.2, 1.2, -1.57, -1.57, 0]
  movej(target, a=1.4, v=1.05)
  assert_joints_near(get_actual_joint_positions(), target, deg=0.1)
end

# @case 2, 4
# @case 5, 10
def test_numbers_are_doubled(given, expected):
  assert_equal(2 * given, expected)
end
`;

export interface Parts {
  readonly pendant: Pendant;
  readonly server: LanguageServer;
  readonly status: Status;
  readonly tasks: Tasks;
  readonly tests: TestExplorer;
  readonly log: vscode.LogOutputChannel;
}

export function registerCommands(parts: Parts): vscode.Disposable[] {
  const { pendant, server, status, tasks, tests, log } = parts;
  const commands: { readonly [name: string]: (...args: never[]) => unknown } = {
    'pendant.run': async (from?: unknown) => {
      const program = await savedProgram(from);
      if (program !== undefined) {
        await tasks.run(program);
      }
    },
    'pendant.debug': async (from?: unknown) => {
      const program = await savedProgram(from);
      if (program !== undefined) {
        await debugProgram(program);
      }
    },
    'pendant.runTest': (uri: string, name: string) => tests.runTest(vscode.Uri.parse(uri), name),
    'pendant.debugTest': (uri: string, name: string) => tests.debugTest(vscode.Uri.parse(uri), name),
    'pendant.openWindow': async (from?: unknown) => {
      const file = await savedProgram(from);
      if (file !== undefined) {
        openWindow(pendant, file, log);
      }
    },
    'pendant.showRobot': () => vscode.commands.executeCommand('pendant.robot.focus'),
    'pendant.newProgram': () => newDocument(PROGRAM),
    'pendant.newTests': () => newDocument(TESTS),
    'pendant.restart': () => server.restart(),
    'pendant.showOutput': () => log.show(),
    'pendant.choose': () => pendant.choose(),
    'pendant.menu': () => status.menu(),
    ...pastCommands,
  };
  return Object.entries(commands).map(([name, does]) => vscode.commands.registerCommand(name, does));
}

async function newDocument(content: string): Promise<void> {
  await vscode.window.showTextDocument(await vscode.workspace.openTextDocument({ language: 'urscript', content }));
}

/**
 * The program that is meant, on the disk as it stands in the editor.
 *
 * @param from a URI as a code lens or a menu hands it, or nothing for the open editor
 */
async function savedProgram(from: unknown): Promise<vscode.Uri | undefined> {
  const uri =
    typeof from === 'string' ? vscode.Uri.parse(from) : from instanceof vscode.Uri ? from : undefined;
  const wanted = uri ?? vscode.window.activeTextEditor?.document.uri;
  if (wanted === undefined) {
    void vscode.window.showErrorMessage('Open a program first.');
    return undefined;
  }
  const document = vscode.workspace.textDocuments.find((each) => each.uri.toString() === wanted.toString());
  if (document?.isUntitled === true) {
    return vscode.workspace.saveAs(document.uri);
  }
  if (document?.isDirty === true && !(await document.save())) {
    return undefined;
  }
  return wanted;
}

function openWindow(pendant: Pendant, file: vscode.Uri, log: vscode.LogOutputChannel): void {
  const command = pendant.demand();
  if (command === undefined) {
    return;
  }
  const child = spawn(command, ['open', '--', file.fsPath], {
    cwd: path.dirname(file.fsPath),
    detached: true,
    stdio: ['ignore', 'ignore', 'pipe'],
  });
  child.stderr.setEncoding('utf8');
  child.stderr.on('data', (text: string) => log.info(text.trimEnd()));
  child.on('error', (error) => void vscode.window.showErrorMessage(`Pendant's window: ${error.message}`));
  child.on('exit', (code) => {
    if (code !== 0 && code !== null) {
      void vscode.window.showErrorMessage(`Pendant's window ended with ${code}; the output says why.`);
    }
  });
}
