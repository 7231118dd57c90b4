/** The language client: starts `pendant lsp`, and starts it anew where settings or people want that. */
import * as vscode from 'vscode';
import { LanguageClient, State, type ServerOptions } from 'vscode-languageclient/node';
import type { Pendant } from '../executable/pendant';

export type ServerState =
  | { readonly kind: 'off' | 'starting' }
  | { readonly kind: 'running'; readonly version: string }
  | { readonly kind: 'missing' }
  | { readonly kind: 'failed'; readonly why: string };

export class LanguageServer implements vscode.Disposable {
  private readonly changed = new vscode.EventEmitter<ServerState>();
  readonly onDidChange = this.changed.event;
  private readonly output = vscode.window.createOutputChannel('Pendant Language Server', { log: true });
  private client: LanguageClient | undefined;
  /** Starts and stops, one after the other. */
  private work: Promise<void> = Promise.resolve();
  private current: ServerState = { kind: 'off' };

  constructor(private readonly pendant: Pendant) {}

  get state(): ServerState {
    return this.current;
  }

  /** Starts it, if it does not run. */
  start(): Promise<void> {
    return this.queue(() => this.begin());
  }

  /** Ends it and starts what the settings say now. */
  restart(): Promise<void> {
    return this.queue(async () => {
      await this.end();
      await this.begin();
    });
  }

  stop(): Promise<void> {
    return this.queue(() => this.end());
  }

  show(): void {
    this.output.show();
  }

  dispose(): void {
    this.changed.dispose();
    this.output.dispose();
  }

  private queue(step: () => Promise<void>): Promise<void> {
    this.work = this.work.then(step, step);
    return this.work;
  }

  private async begin(): Promise<void> {
    if (this.client !== undefined) {
      return;
    }
    const command = this.pendant.offer();
    if (command === undefined) {
      this.be({ kind: 'missing' });
      return;
    }
    const client = new LanguageClient('pendant', 'Pendant', run(command), {
      documentSelector: [
        { scheme: 'file', language: 'urscript' },
        { scheme: 'untitled', language: 'urscript' },
      ],
      initializationOptions: settings(),
      synchronize: {
        configurationSection: 'pendant',
        fileEvents: vscode.workspace.createFileSystemWatcher('**/*.{script,urscript}'),
      },
      outputChannel: this.output,
      markdown: { isTrusted: false, supportHtml: false },
      middleware: {
        provideCompletionItem: async (document, position, context, token, next) =>
          withHints(await next(document, position, context, token)),
      },
    });
    this.client = client;
    client.onDidChangeState((event) => {
      if (event.newState === State.Running) {
        this.be({ kind: 'running', version: client.initializeResult?.serverInfo?.version ?? '' });
      } else if (event.newState === State.Starting) {
        this.be({ kind: 'starting' });
      } else if (this.client === client) {
        this.be({ kind: 'failed', why: 'The language server has ended.' });
      }
    });
    try {
      await client.start();
    } catch (error) {
      this.be({ kind: 'failed', why: error instanceof Error ? error.message : String(error) });
    }
  }

  private async end(): Promise<void> {
    const client = this.client;
    this.client = undefined;
    if (client !== undefined) {
      // One that has failed to start refuses this.
      await client.dispose().catch(() => undefined);
    }
    this.be({ kind: 'off' });
  }

  private be(state: ServerState): void {
    this.current = state;
    this.changed.fire(state);
  }
}

/** Calls that are completed show their arguments at once: a command of VS Code, which no server can name. */
function withHints<T extends vscode.CompletionItem[] | vscode.CompletionList | null | undefined>(offered: T): T {
  const items = Array.isArray(offered) ? offered : (offered?.items ?? []);
  for (const item of items) {
    if (item.kind === vscode.CompletionItemKind.Function && item.insertText instanceof vscode.SnippetString) {
      item.command ??= { title: 'Arguments', command: 'editor.action.triggerParameterHints' };
    }
  }
  return offered;
}

function settings(): object {
  const all = vscode.workspace.getConfiguration('pendant');
  return { inlayHints: all.get('inlayHints'), dryRun: all.get('dryRun'), robot: all.get('robot') };
}

function run(command: string): ServerOptions {
  return { command, args: ['lsp'] };
}
