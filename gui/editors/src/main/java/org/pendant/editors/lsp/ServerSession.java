package org.pendant.editors.lsp;

import static org.pendant.editors.lsp.LanguageServerTexts.text;

import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import org.eclipse.lsp4j.MessageParams;
import org.eclipse.lsp4j.MessageType;
import org.eclipse.lsp4j.jsonrpc.CancelChecker;
import org.eclipse.lsp4j.jsonrpc.CompletableFutures;
import org.eclipse.lsp4j.jsonrpc.ResponseErrorException;
import org.eclipse.lsp4j.jsonrpc.messages.ResponseError;
import org.eclipse.lsp4j.jsonrpc.messages.ResponseErrorCode;
import org.eclipse.lsp4j.services.LanguageClient;
import org.pendant.editors.lsp.provider.ClientFeatures;
import org.pendant.editors.lsp.text.Catalogues;
import org.pendant.editors.lsp.text.Documents;

/**
 * Server session: what the parts of the server share while one client is connected, and the threads
 * that work for it: one answers requests in their order, one does what nobody waits for, and one
 * looks at all files at once, which may take long and must not delay the others.
 */
final class ServerSession implements AutoCloseable {
  private final Documents documents = new Documents(new Catalogues());
  private final ExecutorService answers = Executors.newSingleThreadExecutor(named("answers"));
  private final ScheduledExecutorService background =
      Executors.newSingleThreadScheduledExecutor(named("background"));
  private final ExecutorService workspace = Executors.newSingleThreadExecutor(named("workspace"));
  private final Consumer<Throwable> faults;
  private volatile ClientFeatures features = ClientFeatures.LEAST;
  private volatile ServerSettings settings = ServerSettings.DEFAULT;
  private volatile LanguageClient client;

  /**
   * A session before the client has said anything.
   *
   * @param faults is told of what goes wrong in the server itself
   */
  ServerSession(Consumer<Throwable> faults) {
    this.faults = faults;
  }

  private static ThreadFactory named(String work) {
    return task -> {
      Thread thread = new Thread(task, "language server " + work);
      thread.setDaemon(true);
      return thread;
    };
  }

  Documents documents() {
    return documents;
  }

  LanguageClient client() {
    return client;
  }

  void connect(LanguageClient connected) {
    client = connected;
  }

  ClientFeatures features() {
    return features;
  }

  void learn(ClientFeatures told) {
    features = told;
  }

  ServerSettings settings() {
    return settings;
  }

  void use(ServerSettings told) {
    settings = told;
  }

  /** Has {@code answer} computed after the answers to earlier requests. */
  <R> CompletableFuture<R> answer(Function<CancelChecker, R> answer) {
    return CompletableFutures.computeAsync(
        answers,
        cancelled -> {
          cancelled.checkCanceled();
          return guarded(() -> answer.apply(cancelled));
        });
  }

  /** As {@link #answer}, for what looks at all files and need not be in order. */
  <R> CompletableFuture<R> answerOfWorkspace(Function<CancelChecker, R> answer) {
    return CompletableFutures.computeAsync(
        workspace,
        cancelled -> {
          cancelled.checkCanceled();
          return guarded(() -> answer.apply(cancelled));
        });
  }

  private <R> R guarded(Supplier<R> answer) {
    try {
      return answer.get();
    } catch (ResponseErrorException | CancellationException e) {
      throw e;
    } catch (RuntimeException | StackOverflowError e) {
      faults.accept(e);
      throw new ResponseErrorException(
          new ResponseError(ResponseErrorCode.InternalError, text("internalError", e), null));
    }
  }

  /**
   * Takes over what the client tells. It waits for no answer, so that what cannot be taken over is
   * shown to the user.
   */
  void attempt(Runnable notification) {
    try {
      notification.run();
    } catch (IllegalArgumentException e) {
      client.showMessage(new MessageParams(MessageType.Error, features.shown(e.getMessage())));
    } catch (RuntimeException e) {
      faults.accept(e);
    }
  }

  /** Has {@code work} done by {@code executor}; a fault in it is told. */
  void execute(Executor executor, Runnable work) {
    executor.execute(() -> run(work));
  }

  private void run(Runnable work) {
    try {
      work.run();
    } catch (RuntimeException | StackOverflowError e) {
      faults.accept(e);
    }
  }

  /** Has {@code work} done in {@code delayMs} milliseconds; a fault in it is told. */
  void later(Runnable work, long delayMs) {
    try {
      // The work tells its faults itself.
      var _ = background.schedule(() -> run(work), delayMs, TimeUnit.MILLISECONDS);
    } catch (RejectedExecutionException e) {
      // the client has left, and nobody waits for it any more
    }
  }

  @Override
  public void close() {
    answers.shutdownNow();
    background.shutdownNow();
    workspace.shutdownNow();
  }
}
