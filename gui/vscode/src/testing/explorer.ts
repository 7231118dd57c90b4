/** The test explorer: the tests of all files `*_test.script`, run by `pendant test`. */
import * as path from 'node:path';
import * as vscode from 'vscode';
import type { Pendant } from '../executable/pendant';
import { TestDebugging, debugItems } from './debugging';
import { discover, holdsTests } from './discovery';
import type { Call, Place, TestOutcome } from './junit';
import type { FileReach } from './lcov';
import { runTests } from './process';
import { Progress } from './progress';
import { functionOf, selection, type Wanted } from './selection';

const FILES = '**/*_test.script';
const LEFT_OUT = '**/{node_modules,target,build}/**';

export class TestExplorer implements vscode.Disposable {
  private readonly controller = vscode.tests.createTestController('pendant', 'Pendant');
  private readonly subscriptions: vscode.Disposable[] = [this.controller];
  private readonly debugging = new TestDebugging();
  private readonly runProfile: vscode.TestRunProfile;
  private readonly debugProfile: vscode.TestRunProfile;
  private readonly details = new WeakMap<vscode.FileCoverage, vscode.FileCoverageDetail[]>();

  constructor(private readonly pendant: Pendant) {
    this.controller.resolveHandler = async (item) => {
      if (item === undefined) {
        await this.findAll();
      } else if (item.uri !== undefined) {
        await this.readFile(item.uri);
      }
    };
    this.controller.refreshHandler = () => this.findAll();
    this.runProfile = this.profile('Run', vscode.TestRunProfileKind.Run, false);
    this.debugProfile = this.controller.createRunProfile(
      'Debug',
      vscode.TestRunProfileKind.Debug,
      (request, token) => this.debug(request, token),
      true,
    );
    this.subscriptions.push(this.debugging, this.debugProfile);
    this.profile('Run with Coverage', vscode.TestRunProfileKind.Coverage, true);
    this.watch();
  }

  dispose(): void {
    this.subscriptions.forEach((each) => each.dispose());
  }

  /** Runs one test, as its code lens wants it. */
  async runTest(uri: vscode.Uri, name: string): Promise<void> {
    const test = await this.known(uri, name);
    if (test !== undefined) {
      const request = new vscode.TestRunRequest([test], undefined, this.runProfile);
      await this.run(request, new vscode.CancellationTokenSource().token, false);
    }
  }

  /** Debugs one test, as its code lens wants it. */
  async debugTest(uri: vscode.Uri, name: string): Promise<void> {
    const test = await this.known(uri, name);
    if (test !== undefined) {
      const request = new vscode.TestRunRequest([test], undefined, this.debugProfile);
      await this.debug(request, new vscode.CancellationTokenSource().token);
    }
  }

  private async known(uri: vscode.Uri, name: string): Promise<vscode.TestItem | undefined> {
    await this.readFile(uri);
    const test = this.controller.items.get(uri.toString())?.children.get(name);
    if (test === undefined) {
      void vscode.window.showErrorMessage(`There is no test ${name} in ${vscode.workspace.asRelativePath(uri)}.`);
    }
    return test;
  }

  private async debug(request: vscode.TestRunRequest, token: vscode.CancellationToken): Promise<void> {
    if (this.pendant.demand() === undefined) {
      return;
    }
    await vscode.workspace.saveAll(false);
    if (wantsAll(request)) {
      await this.findAll();
    }
    const items = this.chosen(request).flatMap(leaves);
    await debugItems(this.debugging, this.controller.createTestRun(request), items, token);
  }

  private profile(label: string, kind: vscode.TestRunProfileKind, coverage: boolean): vscode.TestRunProfile {
    const profile = this.controller.createRunProfile(
      label,
      kind,
      (request, token) => this.run(request, token, coverage),
      true,
    );
    profile.loadDetailedCoverage = async (_run, file) => this.details.get(file) ?? [];
    this.subscriptions.push(profile);
    return profile;
  }

  private watch(): void {
    const files = vscode.workspace.createFileSystemWatcher(FILES);
    this.subscriptions.push(
      files,
      files.onDidCreate((uri) => this.readFile(uri)),
      files.onDidChange((uri) => this.readFile(uri)),
      files.onDidDelete((uri) => this.controller.items.delete(uri.toString())),
      vscode.workspace.onDidOpenTextDocument((document) => this.readDocument(document)),
      vscode.workspace.onDidChangeTextDocument((event) => this.readDocument(event.document)),
      vscode.workspace.onDidChangeWorkspaceFolders(() => this.findAll()),
    );
    vscode.workspace.textDocuments.forEach((each) => this.readDocument(each));
  }

  private async findAll(): Promise<void> {
    const found = await vscode.workspace.findFiles(FILES, LEFT_OUT);
    const known = new Set(found.map((uri) => uri.toString()));
    for (const [id, item] of this.controller.items) {
      if (!known.has(id) && item.uri !== undefined && !isOpen(item.uri)) {
        this.controller.items.delete(id);
      }
    }
    await Promise.all(found.map((uri) => this.readFile(uri)));
  }

  private async readFile(uri: vscode.Uri): Promise<void> {
    const open = vscode.workspace.textDocuments.find((each) => each.uri.toString() === uri.toString());
    if (open !== undefined) {
      this.readDocument(open);
      return;
    }
    try {
      this.read(uri, Buffer.from(await vscode.workspace.fs.readFile(uri)).toString('utf8'));
    } catch {
      this.controller.items.delete(uri.toString());
    }
  }

  private readDocument(document: vscode.TextDocument): void {
    if (document.uri.scheme === 'file' && holdsTests(document.uri.path)) {
      this.read(document.uri, document.getText());
    }
  }

  private read(uri: vscode.Uri, text: string): void {
    const id = uri.toString();
    const tests = discover(text);
    if (tests.length === 0) {
      this.controller.items.delete(id);
      return;
    }
    let file = this.controller.items.get(id);
    if (file === undefined) {
      file = this.controller.createTestItem(id, vscode.workspace.asRelativePath(uri), uri);
      this.controller.items.add(file);
    }
    const before = file.children;
    const now = tests.map((test, i) => {
      // Kept where it was there before, with its cases: VS Code keeps its last result by the object.
      const item = before.get(test.name) ?? this.controller.createTestItem(test.name, test.name, uri);
      item.range = new vscode.Range(test.line, test.column, test.line, test.column + test.name.length);
      item.sortText = String(i).padStart(6, '0');
      item.tags = test.tags.map((tag) => new vscode.TestTag(tag));
      item.description = test.skipped === undefined ? '' : `skipped: ${test.skipped}`;
      const cases = test.cases.map((each) => `${test.name}[${each}]`);
      item.children.forEach((each) => {
        if (!cases.includes(each.id)) {
          item.children.delete(each.id);
        }
      });
      for (const each of cases) {
        this.caseOf(item, each).range = item.range;
      }
      return item;
    });
    file.children.replace(now);
  }

  private async run(
    request: vscode.TestRunRequest,
    token: vscode.CancellationToken,
    coverage: boolean,
  ): Promise<void> {
    const command = this.pendant.demand();
    if (command === undefined) {
      return;
    }
    await vscode.workspace.saveAll(false);
    if (wantsAll(request)) {
      // Nobody may have looked at the Testing view yet.
      await this.findAll();
    }
    const run = this.controller.createTestRun(request);
    const stop = new AbortController();
    const cancelled = token.onCancellationRequested(() => stop.abort());
    try {
      for (const [folder, items] of byFolder(this.chosen(request))) {
        await this.runIn(folder, items, { command, coverage, run, stop: stop.signal });
      }
    } finally {
      cancelled.dispose();
      run.end();
    }
  }

  /** The items that are wanted: files, tests and cases, none below another one. */
  private chosen(request: vscode.TestRunRequest): vscode.TestItem[] {
    const excluded = new Set(request.exclude ?? []);
    const chosen: vscode.TestItem[] = [];
    const add = (item: vscode.TestItem) => {
      if (excluded.has(item)) {
        return;
      }
      const split = [...item.children].some(([, child]) => excluded.has(child));
      if (split) {
        item.children.forEach(add);
      } else {
        chosen.push(item);
      }
    };
    if (wantsAll(request)) {
      this.controller.items.forEach(add);
    } else {
      request.include?.forEach(add);
    }
    return chosen;
  }

  private async runIn(
    folder: string,
    items: readonly vscode.TestItem[],
    how: { command: string; coverage: boolean; run: vscode.TestRun; stop: AbortSignal },
  ): Promise<void> {
    const { run } = how;
    const waiting = new Set<vscode.TestItem>();
    const wanted = items.map((item) => want(item, folder));
    for (const item of items) {
      leaves(item).forEach((each) => waiting.add(each));
    }
    waiting.forEach((each) => run.started(each));
    const progress = new Progress();
    const extra = vscode.workspace
      .getConfiguration('pendant', vscode.Uri.file(folder))
      .get<string[]>('test.arguments', []);
    try {
      const { report, reach } = await runTests(
        { command: how.command, folder, arguments: [...extra, ...selection(wanted)], coverage: how.coverage },
        (text) => {
          run.appendOutput(text.replaceAll('\r\n', '\n').replaceAll('\n', '\r\n'));
          for (const each of progress.take(text)) {
            const item = this.find(each.file, each.name, folder);
            if (item !== undefined && waiting.delete(item)) {
              run.passed(item);
            }
          }
        },
        how.stop,
      );
      for (const outcome of report.tests) {
        this.tell(outcome, folder, items, waiting, run);
      }
      for (const broken of report.broken) {
        const message = new vscode.TestMessage(broken.message);
        setLocation(message, broken.place, folder);
        const file = this.controller.items.get(uriOf(broken.file, folder).toString());
        file?.children.forEach((each) => {
          if (waiting.delete(each)) {
            run.errored(each, message);
          }
        });
      }
      reach.forEach((each) => this.cover(each, folder, run));
      waiting.forEach((each) => run.skipped(each));
    } catch (error) {
      const message = new vscode.TestMessage(error instanceof Error ? error.message : String(error));
      waiting.forEach((each) => run.errored(each, message));
    }
  }

  private tell(
    outcome: TestOutcome,
    folder: string,
    items: readonly vscode.TestItem[],
    waiting: Set<vscode.TestItem>,
    run: vscode.TestRun,
  ): void {
    const item = this.find(outcome.file, outcome.name, folder);
    if (item === undefined || !items.some((each) => isWithin(item, each))) {
      // A filter is a part of a name: this one has run beside those that were wanted.
      return;
    }
    waiting.delete(item);
    if (item.id !== functionOf(item.id) && item.parent !== undefined) {
      waiting.delete(item.parent);
    }
    switch (outcome.status) {
      case 'passed':
        run.passed(item, outcome.robotTimeMs);
        break;
      case 'skipped':
        run.skipped(item);
        break;
      case 'failed':
        run.failed(item, message(outcome, folder), outcome.robotTimeMs);
        break;
      case 'error':
        run.errored(item, message(outcome, folder), outcome.robotTimeMs);
        break;
    }
  }

  private find(file: string, name: string, folder: string): vscode.TestItem | undefined {
    const test = this.controller.items.get(uriOf(file, folder).toString())?.children.get(functionOf(name));
    return test === undefined || test.id === name ? test : this.caseOf(test, name);
  }

  /** The case of a test; made where a report names one that its text did not. */
  private caseOf(test: vscode.TestItem, name: string): vscode.TestItem {
    const known = test.children.get(name);
    if (known !== undefined) {
      return known;
    }
    const made = this.controller.createTestItem(name, name.slice(test.id.length), test.uri);
    made.sortText = String(test.children.size).padStart(6, '0');
    if (test.range !== undefined) {
      made.range = test.range;
    }
    test.children.add(made);
    return made;
  }

  private cover(reach: FileReach, folder: string, run: vscode.TestRun): void {
    const functions = reach.functions.map(
      (each) => new vscode.DeclarationCoverage(each.name, each.count, new vscode.Position(each.line, 0)),
    );
    const lines = reach.lines.map((each) => {
      const branches = reach.branches
        .filter((branch) => branch.line === each.line)
        .map((branch) => new vscode.BranchCoverage(branch.count, new vscode.Position(branch.line, 0), branch.label));
      return new vscode.StatementCoverage(each.count, new vscode.Position(each.line, 0), branches);
    });
    const details = [...functions, ...lines];
    const file = vscode.FileCoverage.fromDetails(uriOf(reach.file, folder), details);
    this.details.set(file, details);
    run.addCoverage(file);
  }
}

function wantsAll(request: vscode.TestRunRequest): boolean {
  return request.include === undefined || request.include.length === 0;
}

function byFolder(items: readonly vscode.TestItem[]): Map<string, vscode.TestItem[]> {
  const folders = new Map<string, vscode.TestItem[]>();
  for (const item of items) {
    if (item.uri === undefined) {
      continue;
    }
    const folder = vscode.workspace.getWorkspaceFolder(item.uri)?.uri.fsPath ?? path.dirname(item.uri.fsPath);
    const known = folders.get(folder);
    if (known === undefined) {
      folders.set(folder, [item]);
    } else {
      known.push(item);
    }
  }
  return folders;
}

function want(item: vscode.TestItem, folder: string): Wanted {
  const file = path.relative(folder, item.uri?.fsPath ?? '');
  return { file, name: item.parent === undefined ? undefined : item.id };
}

function leaves(item: vscode.TestItem): vscode.TestItem[] {
  return item.children.size === 0 ? [item] : [...item.children].flatMap(([, child]) => leaves(child));
}

function isWithin(item: vscode.TestItem, other: vscode.TestItem): boolean {
  for (let each: vscode.TestItem | undefined = item; each !== undefined; each = each.parent) {
    if (each === other) {
      return true;
    }
  }
  return false;
}

function message(outcome: TestOutcome, folder: string): vscode.TestMessage {
  const output = outcome.output === '' ? '' : `\n\nOutput:\n${outcome.output.replace(/\n$/, '')}`;
  // The place of the first line is that of the message.
  const [, ...more] = outcome.details.split('\n');
  const made = new vscode.TestMessage([outcome.message, ...more].join('\n') + output);
  setLocation(made, outcome.place, folder);
  made.stackTrace = outcome.stack.map((each) => frame(each, folder));
  return made;
}

function frame(call: Call, folder: string): vscode.TestMessageStackFrame {
  return new vscode.TestMessageStackFrame(call.name, uriOf(call.place.file, folder), position(call.place));
}

function setLocation(message: vscode.TestMessage, place: Place | undefined, folder: string): void {
  if (place !== undefined) {
    message.location = new vscode.Location(uriOf(place.file, folder), position(place));
  }
}

function position(place: Place): vscode.Position {
  return new vscode.Position(Math.max(0, place.line), Math.max(0, place.column));
}

function uriOf(file: string, folder: string): vscode.Uri {
  return vscode.Uri.file(path.resolve(folder, file));
}

function isOpen(uri: vscode.Uri): boolean {
  return vscode.workspace.textDocuments.some((each) => each.uri.toString() === uri.toString());
}
