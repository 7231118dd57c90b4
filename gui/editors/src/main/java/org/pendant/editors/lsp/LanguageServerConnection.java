package org.pendant.editors.lsp;

import static org.pendant.editors.lsp.LanguageServerTexts.text;

import java.io.InputStream;
import java.io.OutputStream;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletionException;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import org.eclipse.lsp4j.jsonrpc.Launcher;
import org.eclipse.lsp4j.jsonrpc.ResponseErrorException;
import org.eclipse.lsp4j.jsonrpc.messages.ResponseError;
import org.eclipse.lsp4j.jsonrpc.messages.ResponseErrorCode;
import org.eclipse.lsp4j.services.LanguageClient;
import org.pendant.editors.wire.CheckedFrames;

/** Language server connection: serves one client over two streams until it leaves. */
public final class LanguageServerConnection {
  private LanguageServerConnection() {}

  /**
   * Serves the client until it says {@code exit} or its stream ends; the caller waits.
   *
   * @param version of Pendant
   * @param faults is told of what goes wrong in the server itself
   * @param complaints is told what of the client's bytes is left out
   * @return whether the client shut the server down as the protocol wants it
   * @throws InterruptedException if the thread is interrupted
   */
  public static boolean serve(
      String version,
      InputStream input,
      OutputStream output,
      Consumer<Throwable> faults,
      Consumer<String> complaints)
      throws InterruptedException {
    ExecutorService reader =
        Executors.newSingleThreadExecutor(
            task -> {
              Thread thread = new Thread(task, "language server reader");
              thread.setDaemon(true);
              return thread;
            });
    try (ScriptLanguageServer server = new ScriptLanguageServer(version, faults)) {
      Launcher<LanguageClient> launcher =
          new Launcher.Builder<LanguageClient>()
              .setLocalServices(List.of(server, server.robotRequests()))
              .setRemoteInterface(LanguageClient.class)
              .setClassLoader(LanguageClient.class.getClassLoader())
              .setInput(new CheckedFrames(input, complaints))
              .setOutput(output)
              .setExecutorService(reader)
              .setExceptionHandler(fault -> answer(fault, faults, server::shown))
              .create();
      server.connect(launcher.getRemoteProxy());
      var _ = launcher.startListening();
      // The one thread comes to this when the client's stream has ended.
      reader.execute(server::exit);
      return server.ended().get();
    } catch (ExecutionException e) {
      throw new IllegalStateException(e);
    } finally {
      reader.shutdownNow();
    }
  }

  /** What a client is told of a request that failed. */
  private static ResponseError answer(
      Throwable fault, Consumer<Throwable> faults, UnaryOperator<String> shown) {
    Throwable cause = fault;
    while (cause instanceof CompletionException && cause.getCause() != null) {
      cause = cause.getCause();
    }
    return switch (cause) {
      case ResponseErrorException refused -> shown(refused.getResponseError(), shown);
      case CancellationException _ ->
          new ResponseError(
              ResponseErrorCode.RequestCancelled, shown.apply(text("cancelled")), null);
      // What the server says that it cannot do, and an editor asks for all the same.
      case UnsupportedOperationException _ ->
          new ResponseError(
              ResponseErrorCode.MethodNotFound, shown.apply(text("notSupported")), null);
      default -> {
        faults.accept(cause);
        yield new ResponseError(
            ResponseErrorCode.InternalError, shown.apply(text("internalError", cause)), null);
      }
    };
  }

  private static ResponseError shown(ResponseError refusal, UnaryOperator<String> shown) {
    return new ResponseError(
        refusal.getCode(), shown.apply(refusal.getMessage()), refusal.getData());
  }
}
