/** The view *Robot* in the panel below: the arm, joints and signals while a program runs and where it stops. */
import * as vscode from 'vscode';
import type { DebugProtocol } from '@vscode/debugprotocol';
import { Follower } from './follower';
import type { Show, Wish } from './messages';

const TYPE = 'pendant';

export class RobotPanel implements vscode.WebviewViewProvider, vscode.DebugAdapterTrackerFactory {
  private view: vscode.WebviewView | undefined;
  private follower: Follower | undefined;

  constructor(
    private readonly extension: vscode.Uri,
    private readonly log: vscode.LogOutputChannel,
  ) {}

  resolveWebviewView(view: vscode.WebviewView): void {
    this.view = view;
    const out = vscode.Uri.joinPath(this.extension, 'out');
    view.webview.options = { enableScripts: true, localResourceRoots: [out] };
    view.webview.html = page(view.webview, out);
    view.webview.onDidReceiveMessage((wish: Wish) => this.carryOut(wish).catch((error) => this.refused(error)));
    view.onDidDispose(() => {
      this.view = undefined;
    });
  }

  createDebugAdapterTracker(session: vscode.DebugSession): vscode.DebugAdapterTracker {
    return {
      onWillStartSession: () => {
        this.follower?.end();
        this.follower = new Follower(
          session,
          () => this.show(),
          () => this.view?.visible === true,
          (text) => this.log.warn(`robot panel: ${text}`),
        );
        // The view is there from the first session on, and stays.
        void vscode.commands.executeCommand('setContext', 'pendant.debugged', true);
        this.show();
      },
      onDidSendMessage: (message: DebugProtocol.ProtocolMessage) => {
        const follower = this.follower;
        if (session !== follower?.session) {
          return;
        }
        if (isAnswer(message, 'launch') || isAnswer(message, 'attach')) {
          follower.follow();
        } else if (LEADING_ON.some((each) => isAnswer(message, each))) {
          follower.continued();
        } else if (message.type === 'event') {
          const event = message as DebugProtocol.Event;
          if (event.event === 'terminated') {
            follower.end();
          } else {
            follower.hear(event);
          }
        }
      },
      onWillStopSession: () => this.end(session),
      onExit: () => this.end(session),
    };
  }

  /** The session whose robot is shown, while it lasts. */
  get following(): Follower | undefined {
    return this.follower?.state === 'ended' ? undefined : this.follower;
  }

  private end(session: vscode.DebugSession): void {
    if (session === this.follower?.session && this.follower.state !== 'ended') {
      this.follower.end();
    }
  }

  private show(): void {
    const follower = this.follower;
    const shown: Show = {
      kind: 'show',
      state: follower?.state ?? 'none',
      stops: follower?.stops.all ?? [],
      now: follower?.now,
      timeline: follower?.timeline,
      log: follower?.log ?? [],
    };
    void this.view?.webview.postMessage(shown);
  }

  private refused(error: unknown): void {
    void vscode.window.showErrorMessage(error instanceof Error ? error.message : String(error));
    this.show();
  }

  private async carryOut(wish: Wish): Promise<void> {
    const following = this.following;
    switch (wish.kind) {
      case 'ready':
        this.show();
        break;
      case 'open':
        await this.open(wish.stop);
        break;
      case 'signal':
        await following?.setSignal(wish.bank, wish.index, wish.on);
        break;
      case 'time':
        await following?.lookAt(wish.timeS, wish.stay);
        break;
      case 'now':
        await following?.lookAtNow();
        break;
      case 'step':
        await following?.step(wish.step);
        break;
      case 'moment':
        await following?.goToMoment(wish.id);
        break;
    }
  }

  private async open(number: number): Promise<void> {
    const stop = this.follower?.stops.find(number);
    if (stop !== undefined && stop.file !== '' && stop.line > 0) {
      const place = new vscode.Position(stop.line - 1, 0);
      const range = new vscode.Range(place, place);
      const editor = await vscode.window.showTextDocument(vscode.Uri.file(stop.file), { preserveFocus: true });
      editor.selection = new vscode.Selection(place, place);
      editor.revealRange(range, vscode.TextEditorRevealType.InCenterIfOutsideViewport);
    }
  }
}

/** Requests after which the program goes on. */
const LEADING_ON = ['continue', 'next', 'stepIn', 'stepOut', 'goto', 'pendant/stepToMove'];

function isAnswer(message: DebugProtocol.ProtocolMessage, command: string): boolean {
  const answer = message as DebugProtocol.Response;
  return message.type === 'response' && answer.command === command && answer.success;
}

export function registerPanel(panel: RobotPanel): vscode.Disposable[] {
  return [
    vscode.window.registerWebviewViewProvider('pendant.robot', panel, {
      webviewOptions: { retainContextWhenHidden: true },
    }),
    vscode.debug.registerDebugAdapterTrackerFactory(TYPE, panel),
  ];
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
