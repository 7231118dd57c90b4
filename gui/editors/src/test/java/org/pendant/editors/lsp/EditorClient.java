package org.pendant.editors.lsp;

import com.google.gson.JsonObject;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.LinkedBlockingQueue;
import org.eclipse.lsp4j.DidChangeTextDocumentParams;
import org.eclipse.lsp4j.DidOpenTextDocumentParams;
import org.eclipse.lsp4j.InitializeParams;
import org.eclipse.lsp4j.InitializeResult;
import org.eclipse.lsp4j.InitializedParams;
import org.eclipse.lsp4j.MessageActionItem;
import org.eclipse.lsp4j.MessageParams;
import org.eclipse.lsp4j.PublishDiagnosticsParams;
import org.eclipse.lsp4j.ShowMessageRequestParams;
import org.eclipse.lsp4j.TextDocumentContentChangeEvent;
import org.eclipse.lsp4j.TextDocumentItem;
import org.eclipse.lsp4j.TextDocumentPositionParams;
import org.eclipse.lsp4j.VersionedTextDocumentIdentifier;
import org.eclipse.lsp4j.jsonrpc.Launcher;
import org.eclipse.lsp4j.jsonrpc.services.JsonRequest;
import org.eclipse.lsp4j.services.LanguageClient;
import org.eclipse.lsp4j.services.LanguageServer;
import org.pendant.editors.wire.BytePipe;

/** An editor for tests, connected to a server of its own by streams. */
final class EditorClient implements LanguageClient, AutoCloseable {
  private final BlockingQueue<PublishDiagnosticsParams> diagnostics = new LinkedBlockingQueue<>();
  private final List<String> complaints = new CopyOnWriteArrayList<>();
  private final List<Throwable> faults = new CopyOnWriteArrayList<>();
  private final CompletableFuture<Boolean> served = new CompletableFuture<>();
  private final BytePipe toServer = new BytePipe();
  private Server server;

  /** The server with what the protocol has no word for. */
  interface Server extends LanguageServer {
    @JsonRequest("pendant/pose")
    CompletableFuture<JsonObject> pose(TextDocumentPositionParams asked);

    @JsonRequest("pendant/dryRun")
    CompletableFuture<JsonObject> dryRun(TextDocumentPositionParams asked);
  }

  static EditorClient start() throws IOException {
    EditorClient editor = new EditorClient();
    BytePipe toClient = new BytePipe();
    Thread.ofPlatform()
        .daemon()
        .start(
            () -> {
              try {
                editor.served.complete(
                    LanguageServerConnection.serve(
                        "test",
                        editor.toServer.input(),
                        toClient.output(),
                        editor.faults::add,
                        editor.complaints::add));
              } catch (Throwable e) {
                editor.served.completeExceptionally(e);
              }
            });
    var launcher =
        new Launcher.Builder<Server>()
            .setLocalService(editor)
            .setRemoteInterface(Server.class)
            .setInput(toClient.input())
            .setOutput(editor.toServer.output())
            .create();
    var _ = launcher.startListening();
    editor.server = launcher.getRemoteProxy();
    return editor;
  }

  Server server() {
    return server;
  }

  InitializeResult initialize(InitializeParams asked) throws Exception {
    CompletableFuture<InitializeResult> answer = server.initialize(asked);
    // A server that cannot even start would never answer.
    CompletableFuture.anyOf(answer, served).get();
    InitializeResult result = answer.get();
    server.initialized(new InitializedParams());
    return result;
  }

  void open(String uri, String text) {
    server
        .getTextDocumentService()
        .didOpen(new DidOpenTextDocumentParams(new TextDocumentItem(uri, "urscript", 1, text)));
  }

  void replace(String uri, int version, String text) {
    server
        .getTextDocumentService()
        .didChange(
            new DidChangeTextDocumentParams(
                new VersionedTextDocumentIdentifier(uri, version),
                List.of(new TextDocumentContentChangeEvent(text))));
  }

  /** Sends bytes beside the protocol. */
  void send(String bytes) throws IOException {
    synchronized (toServer) {
      toServer.output().write(bytes.getBytes(StandardCharsets.ISO_8859_1));
      toServer.output().flush();
    }
  }

  PublishDiagnosticsParams nextDiagnostics() throws InterruptedException {
    return diagnostics.take();
  }

  boolean hasDiagnostics() {
    return !diagnostics.isEmpty();
  }

  List<String> complaints() {
    return complaints;
  }

  List<Throwable> faults() {
    return faults;
  }

  /** Waits for the end of the server: whether it was left in order. */
  boolean served() {
    return served.join();
  }

  @Override
  public void publishDiagnostics(PublishDiagnosticsParams told) {
    diagnostics.add(told);
  }

  @Override
  public void telemetryEvent(Object event) {}

  @Override
  public void showMessage(MessageParams message) {}

  @Override
  public CompletableFuture<MessageActionItem> showMessageRequest(ShowMessageRequestParams asked) {
    return CompletableFuture.completedFuture(null);
  }

  @Override
  public void logMessage(MessageParams message) {}

  @Override
  public void close() throws IOException {
    toServer.output().close();
  }
}
