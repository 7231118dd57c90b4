package org.pendant.editors.lsp;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import org.eclipse.lsp4j.ClientCapabilities;
import org.eclipse.lsp4j.ConfigurationItem;
import org.eclipse.lsp4j.ConfigurationParams;
import org.eclipse.lsp4j.GeneralClientCapabilities;
import org.eclipse.lsp4j.InitializeParams;
import org.eclipse.lsp4j.InitializeResult;
import org.eclipse.lsp4j.InitializedParams;
import org.eclipse.lsp4j.ServerInfo;
import org.eclipse.lsp4j.SetTraceParams;
import org.eclipse.lsp4j.WorkDoneProgressCancelParams;
import org.eclipse.lsp4j.WorkspaceFolder;
import org.eclipse.lsp4j.services.LanguageClient;
import org.eclipse.lsp4j.services.LanguageClientAware;
import org.eclipse.lsp4j.services.LanguageServer;
import org.eclipse.lsp4j.services.TextDocumentService;
import org.eclipse.lsp4j.services.WorkspaceService;
import org.pendant.editors.lsp.provider.ClientFeatures;
import org.pendant.editors.lsp.text.PositionEncoding;

/**
 * Script language server: answers one client about URScript, from {@code initialize} to {@code
 * exit} (Language Server Protocol 3.17).
 */
public final class ScriptLanguageServer
    implements LanguageServer, LanguageClientAware, AutoCloseable {
  private final String version;
  private final ServerSession session;
  private final WorkspaceFiles files;
  private final TextRequests texts;
  private final WorkspaceRequests workspace;
  private final CompletableFuture<Boolean> ended = new CompletableFuture<>();
  private volatile boolean shutDown;

  /**
   * A server for one client.
   *
   * @param version of Pendant, told to the client
   * @param faults is told of what goes wrong in the server itself
   */
  public ScriptLanguageServer(String version, Consumer<Throwable> faults) {
    this.version = version;
    session = new ServerSession(faults);
    files = new WorkspaceFiles(session);
    texts = new TextRequests(session);
    workspace = new WorkspaceRequests(session, files, this::askForSettings);
  }

  @Override
  public void connect(LanguageClient client) {
    session.connect(client);
  }

  @Override
  @SuppressWarnings("deprecation") // clients that know no folders name the root
  public CompletableFuture<InitializeResult> initialize(InitializeParams asked) {
    session.learn(ClientFeatures.of(asked));
    session.use(ServerSettings.of(asked.getInitializationOptions()));
    PositionEncoding encoding = encoding(asked.getCapabilities());
    session.documents().countIn(encoding);
    List<WorkspaceFolder> folders = asked.getWorkspaceFolders();
    if (folders != null) {
      folders.forEach(folder -> files.add(folder.getUri()));
    } else if (asked.getRootUri() != null) {
      files.add(asked.getRootUri());
    }
    return CompletableFuture.completedFuture(
        new InitializeResult(Capabilities.of(encoding), new ServerInfo("Pendant", version)));
  }

  /** The first that the client names of those that are known here; all clients know UTF-16. */
  private static PositionEncoding encoding(ClientCapabilities client) {
    return Optional.ofNullable(client)
        .map(ClientCapabilities::getGeneral)
        .map(GeneralClientCapabilities::getPositionEncodings)
        .flatMap(
            names ->
                names.stream()
                    .flatMap(
                        name ->
                            Arrays.stream(PositionEncoding.values())
                                .filter(each -> each.word().equals(name)))
                    .findFirst())
        .orElse(PositionEncoding.UTF16);
  }

  @Override
  public void initialized(InitializedParams told) {
    if (session.features().configuration()) {
      askForSettings();
    }
  }

  private void askForSettings() {
    ConfigurationItem section = new ConfigurationItem();
    section.setSection(ServerSettings.SECTION);
    var _ =
        session
            .client()
            .configuration(new ConfigurationParams(List.of(section)))
            .thenAccept(
                answers -> {
                  if (!answers.isEmpty()) {
                    session.use(ServerSettings.of(answers.getFirst()));
                  }
                });
  }

  @Override
  public CompletableFuture<Object> shutdown() {
    shutDown = true;
    return CompletableFuture.completedFuture(null);
  }

  @Override
  public void exit() {
    // Behind what was asked before.
    var _ = session.answer(cancelled -> ended.complete(shutDown));
  }

  /** A message as the people at the client read it. */
  String shown(String message) {
    return session.features().shown(message);
  }

  /** Completed by {@code exit}: with whether the client has shut the server down before. */
  public CompletableFuture<Boolean> ended() {
    return ended;
  }

  /** What the protocol has no word for: another service of the same connection. */
  public RobotRequests robotRequests() {
    return new RobotRequests(session, texts.dryRuns());
  }

  @Override
  public TextDocumentService getTextDocumentService() {
    return texts;
  }

  @Override
  public WorkspaceService getWorkspaceService() {
    return workspace;
  }

  @Override
  public void cancelProgress(WorkDoneProgressCancelParams cancelled) {
    // What reports progress is cancelled by its request.
  }

  @Override
  public void setTrace(SetTraceParams wanted) {
    // Nothing is traced.
  }

  @Override
  public void close() {
    texts.dryRuns().close();
    session.close();
  }
}
