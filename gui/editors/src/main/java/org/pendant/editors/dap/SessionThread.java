package org.pendant.editors.dap;

import static org.pendant.editors.dap.DebugAdapterTexts.text;

import java.util.Map;
import java.util.OptionalInt;
import java.util.Queue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.Semaphore;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.eclipse.lsp4j.jsonrpc.MessageConsumer;
import org.eclipse.lsp4j.jsonrpc.RemoteEndpoint;
import org.eclipse.lsp4j.jsonrpc.messages.Message;
import org.eclipse.lsp4j.jsonrpc.messages.RequestMessage;

/**
 * DebugSession thread: does all work of one session in turn: requests, what comes of them, and
 * events. So the answer to a request is written before the events that it causes, on which clients
 * rely: a stop that is told before the answer to <i>continue</i> would be taken for over.
 */
final class SessionThread implements Executor, AutoCloseable {
  /** Events that may wait for a slow client; then the robot waits as well. */
  private static final int MAX_EVENTS = 1000;

  /** How long a client may take for the last message. */
  private static final long LAST_WORDS_MS = 500;

  private final ExecutorService thread =
      Executors.newSingleThreadExecutor(
          Thread.ofPlatform().daemon().name("debug session").factory());
  private final Semaphore places = new Semaphore(MAX_EVENTS);

  /** Requests that the reader has taken, and whose answers nobody awaits yet. */
  private final Queue<Runnable> taken = new ConcurrentLinkedQueue<>();

  /** Answers that clients wait for. */
  private final Map<Long, CompletableFuture<?>> awaited = new ConcurrentHashMap<>();

  private final AtomicLong requests = new AtomicLong();

  /** The reader's: the number that the client has given to the request which it takes. */
  private OptionalInt taking = OptionalInt.empty();

  /** The session's: the number of the request that begins. */
  private OptionalInt beginning = OptionalInt.empty();

  /** A piece of work for an answer. */
  @FunctionalInterface
  interface Work<T> {
    CompletionStage<T> begin();
  }

  /** For the reader: has a request worked on as soon as its answer is awaited. */
  <T> CompletableFuture<T> request(Work<T> work) {
    CompletableFuture<T> answer = new CompletableFuture<>();
    long number = requests.incrementAndGet();
    awaited.put(number, answer);
    var _ = answer.whenComplete((value, fault) -> awaited.remove(number));
    OptionalInt asked = taking;
    taken.add(
        () -> {
          beginning = asked;
          try {
            work.begin()
                .whenComplete(
                    (value, fault) -> {
                      if (fault == null) {
                        answer.complete(value);
                      } else {
                        answer.completeExceptionally(fault);
                      }
                    });
          } catch (RuntimeException | Error e) {
            answer.completeExceptionally(e);
          }
        });
    return answer;
  }

  /** Has the requests begin of which {@code consumer} has been told completely. */
  MessageConsumer gated(MessageConsumer consumer) {
    return consumer instanceof RemoteEndpoint
        ? message -> {
          taking = number(message);
          consumer.consume(message);
          for (Runnable each = taken.poll(); each != null; each = taken.poll()) {
            execute(each);
          }
        }
        : consumer;
  }

  private static OptionalInt number(Message message) {
    return message instanceof RequestMessage request
        ? request.getRawId().map(SessionThread::number, number -> OptionalInt.of(number.intValue()))
        : OptionalInt.empty();
  }

  private static OptionalInt number(String id) {
    try {
      return OptionalInt.of(Integer.parseInt(id));
    } catch (NumberFormatException e) {
      return OptionalInt.empty();
    }
  }

  /** For work as it begins: the number that the client has given to its request. */
  OptionalInt asked() {
    return beginning;
  }

  /** Does something in its turn; nothing once the session is over. */
  @Override
  public void execute(Runnable task) {
    try {
      thread.execute(task);
    } catch (RejectedExecutionException e) {
      // nobody is there any more who could want it
    }
  }

  /**
   * Does something in its turn, and waits while too much waits.
   *
   * @throws InterruptedException if the calling thread is interrupted meanwhile
   */
  void event(Runnable event) throws InterruptedException {
    places.acquire();
    execute(
        () -> {
          places.release();
          event.run();
        });
  }

  /**
   * Forgets what waits, and says so to who asked for it. What is under way may still end, which is
   * waited for unless the client does not listen any more.
   */
  @Override
  public void close() {
    thread.shutdownNow();
    awaited.values().forEach(each -> each.completeExceptionally(Refusals.of(text("sessionEnded"))));
    try {
      var _ = thread.awaitTermination(LAST_WORDS_MS, TimeUnit.MILLISECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
