/** The view *Robot* in the panel below: the arm, joints and signals at each stop. */
import * as vscode from 'vscode';
import type { DebugProtocol } from '@vscode/debugprotocol';
import type { Show, Wish } from './messages';
import { fileOf } from './place';
import { switching } from './outputs';
import { read, type Variable } from './reading';
import { Stops } from './stops';

const TYPE = 'pendant';
const DEFAULT_ARM = 'ur5e';

export class RobotPanel implements vscode.WebviewViewProvider, vscode.DebugAdapterTrackerFactory {
  private view: vscode.WebviewView | undefined;
  private session: vscode.DebugSession | undefined;
  private state: Show['state'] = 'none';
  private readonly stops = new Stops();

  constructor(
    private readonly extension: vscode.Uri,
    private readonly log: vscode.LogOutputChannel,
  ) {}

  resolveWebviewView(view: vscode.WebviewView): void {
    this.view = view;
    const out = vscode.Uri.joinPath(this.extension, 'out');
    view.webview.options = { enableScripts: true, localResourceRoots: [out] };
    view.webview.html = page(view.webview, out);
    view.webview.onDidReceiveMessage((wish: Wish) =>
      this.carryOut(wish).catch((error) => this.log.warn(`robot panel: ${error}`)),
    );
    view.onDidDispose(() => {
      this.view = undefined;
    });
  }

  createDebugAdapterTracker(session: vscode.DebugSession): vscode.DebugAdapterTracker {
    return {
      onWillStartSession: () => {
        this.session = session;
        this.stops.clear();
        // The view is there from the first session on, and stays.
        void vscode.commands.executeCommand('setContext', 'pendant.debugged', true);
        this.be('running');
      },
      onDidSendMessage: (message: DebugProtocol.ProtocolMessage) => {
        if (session === this.session && message.type === 'event') {
          this.hear(session, message as DebugProtocol.Event);
        }
      },
      onWillStopSession: () => this.end(session),
      onExit: () => this.end(session),
    };
  }

  private hear(session: vscode.DebugSession, event: DebugProtocol.Event): void {
    if (event.event === 'stopped') {
      const { threadId, reason, description } = event.body as DebugProtocol.StoppedEvent['body'];
      this.look(session, threadId ?? 1, { reason, description: description ?? '' }).catch((error) => this.log.warn(`robot panel: ${error}`));
    } else if (event.event === 'continued') {
      this.be('running');
    } else if (event.event === 'terminated') {
      this.end(session);
    }
  }

  private end(session: vscode.DebugSession): void {
    if (session === this.session) {
      this.session = undefined;
      this.be('ended');
    }
  }

  /** Asks what there is at a stop. */
  private async look(
    session: vscode.DebugSession,
    threadId: number,
    why: { readonly reason: string; readonly description: string },
  ): Promise<void> {
    const trace: DebugProtocol.StackTraceResponse['body'] = await session.customRequest('stackTrace', {
      threadId,
      startFrame: 0,
      levels: 1,
    });
    const frame = trace.stackFrames[0];
    if (frame === undefined) {
      return;
    }
    const { scopes }: DebugProtocol.ScopesResponse['body'] = await session.customRequest('scopes', {
      frameId: frame.id,
    });
    const robot = await variables(session, scopes, 'Robot');
    const signals = await variables(session, scopes, 'I/O');
    if (session !== this.session) {
      return;
    }
    this.stops.add({
      ...why,
      function: frame.name,
      line: frame.line,
      file: fileOf(frame.source?.path) ?? '',
      reading: read(arm(session), robot, signals),
    });
    this.be('stopped');
  }

  private be(state: Show['state']): void {
    this.state = state;
    this.show();
  }

  private show(): void {
    const shown: Show = { kind: 'show', state: this.state, stops: this.stops.all };
    void this.view?.webview.postMessage(shown);
  }

  private async carryOut(wish: Wish): Promise<void> {
    switch (wish.kind) {
      case 'ready':
        this.show();
        break;
      case 'open':
        await this.open(wish.stop);
        break;
      case 'output':
        await this.switch(wish.bank, wish.index, wish.on);
        break;
    }
  }

  private async open(number: number): Promise<void> {
    const stop = this.stops.find(number);
    if (stop !== undefined && stop.file !== '' && stop.line > 0) {
      const place = new vscode.Position(stop.line - 1, 0);
      const range = new vscode.Range(place, place);
      const editor = await vscode.window.showTextDocument(vscode.Uri.file(stop.file), { preserveFocus: true });
      editor.selection = new vscode.Selection(place, place);
      editor.revealRange(range, vscode.TextEditorRevealType.InCenterIfOutsideViewport);
    }
  }

  private async switch(bank: string, index: number, on: boolean): Promise<void> {
    const expression = switching(bank, index, on);
    const session = this.session;
    const item = vscode.debug.activeStackItem;
    if (expression === undefined || session === undefined || this.state !== 'stopped') {
      return;
    }
    try {
      await session.customRequest('evaluate', {
        expression,
        context: 'repl',
        ...(item instanceof vscode.DebugStackFrame && item.session === session ? { frameId: item.frameId } : {}),
      });
      const thread = item instanceof vscode.DebugStackFrame || item instanceof vscode.DebugThread ? item.threadId : 1;
      await this.look(session, thread, {
        reason: `${bank}[${index}]`,
        description: this.stops.last?.description ?? '',
      });
    } catch (error) {
      void vscode.window.showErrorMessage(error instanceof Error ? error.message : String(error));
      this.show();
    }
  }
}

export function registerPanel(extension: vscode.Uri, log: vscode.LogOutputChannel): vscode.Disposable[] {
  const panel = new RobotPanel(extension, log);
  return [
    vscode.window.registerWebviewViewProvider('pendant.robot', panel, {
      webviewOptions: { retainContextWhenHidden: true },
    }),
    vscode.debug.registerDebugAdapterTrackerFactory(TYPE, panel),
  ];
}

async function variables(
  session: vscode.DebugSession,
  scopes: readonly DebugProtocol.Scope[],
  name: string,
): Promise<Variable[]> {
  const scope = scopes.find((each) => each.name === name);
  if (scope === undefined) {
    return [];
  }
  const answer: DebugProtocol.VariablesResponse['body'] = await session.customRequest('variables', {
    variablesReference: scope.variablesReference,
  });
  return answer.variables;
}

/** The arm that was asked for; one that an installation names is not known here. */
function arm(session: vscode.DebugSession): string {
  const robot: unknown = session.configuration['robot'];
  return typeof robot === 'string' && robot !== '' ? robot : DEFAULT_ARM;
}

function page(webview: vscode.Webview, out: vscode.Uri): string {
  const script = webview.asWebviewUri(vscode.Uri.joinPath(out, 'page.js'));
  const style = webview.asWebviewUri(vscode.Uri.joinPath(out, 'page.css'));
  return `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="UTF-8">
<meta http-equiv="Content-Security-Policy"
  content="default-src 'none'; script-src ${webview.cspSource}; style-src ${webview.cspSource}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Robot</title>
<link rel="stylesheet" href="${style}">
</head>
<body>
<main></main>
<script src="${script}"></script>
</body>
</html>`;
}
