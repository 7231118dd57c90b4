package org.pendant.desktop.timeline;

import static org.pendant.desktop.timeline.TimelineTexts.text;

import java.awt.EventQueue;
import java.io.UncheckedIOException;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.pendant.kit.fault.Faults;

/**
 * Recording reader: reads from recordings, which may have to read a file, outside of the thread
 * that uses it: one after the other, and of what is asked for meanwhile the newest alone.
 *
 * @param <T> what is read
 */
public final class RecordingReader<T> {
  private final Executor reading;
  private final Executor dispatch;
  private Optional<Request<T>> next = Optional.empty();
  private boolean busy;

  /** What to read, and who takes it, or why it cannot be read, in the thread that asked. */
  private record Request<T>(Supplier<T> what, Consumer<? super T> taker, Consumer<String> failed) {}

  /**
   * A reader.
   *
   * @param reading runs what reads a recording
   * @param dispatch runs what comes of it in the thread that uses this object
   */
  RecordingReader(Executor reading, Executor dispatch) {
    this.reading = reading;
    this.dispatch = dispatch;
  }

  /**
   * One for a window.
   *
   * @param name of its threads
   */
  public static <T> RecordingReader<T> ofWindow(String name) {
    return new RecordingReader<>(
        task -> Thread.ofVirtual().name(name).start(task), EventQueue::invokeLater);
  }

  /**
   * Reads something when what was asked for before is done, unless something else is asked for
   * until then.
   *
   * @param what reads it
   * @param taker gets it
   * @param failed gets why it cannot be read any more
   */
  public void read(Supplier<T> what, Consumer<? super T> taker, Consumer<String> failed) {
    next = Optional.of(new Request<>(what, taker, failed));
    begin();
  }

  /** Reads nothing more of what was asked for; what is being read may still come. */
  public void forget() {
    next = Optional.empty();
  }

  private void begin() {
    if (busy || next.isEmpty()) {
      return;
    }
    Request<T> request = next.get();
    next = Optional.empty();
    busy = true;
    reading.execute(
        () -> {
          Runnable told = told(request);
          dispatch.execute(
              () -> {
                busy = false;
                told.run();
                begin();
              });
        });
  }

  private static <T> Runnable told(Request<T> request) {
    try {
      T read = request.what().get();
      return () -> request.taker().accept(read);
    } catch (UncheckedIOException e) {
      return () -> request.failed().accept(e.getCause().getMessage());
    } catch (RuntimeException | Error fault) {
      Faults.report(fault);
      return () -> request.failed().accept(text("internalError", fault));
    }
  }
}
