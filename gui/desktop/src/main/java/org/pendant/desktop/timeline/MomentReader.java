package org.pendant.desktop.timeline;

import java.awt.EventQueue;
import java.io.UncheckedIOException;
import java.util.Optional;
import java.util.concurrent.Executor;
import org.pendant.controller.state.ControllerState;
import org.pendant.kit.fault.Faults;
import org.pendant.recording.Moment;
import org.pendant.recording.Recording;

/**
 * Moment reader: reads moments that are not in memory from the file of a recording, outside of the
 * thread that uses it: one after the other, and of those that are asked for meanwhile the newest
 * alone.
 */
final class MomentReader {
  private final Executor reading;
  private final Executor dispatch;
  private Optional<Request> next = Optional.empty();
  private boolean busy;

  /**
   * A moment to read.
   *
   * @param number higher than that of requests before
   */
  record Request(Recording recording, Moment moment, long number) {}

  /** Takes what was read, in the thread that asked. */
  interface Listener {
    /** What the controller published then. */
    void read(Request request, ControllerState state);

    /** The file cannot be read any more. */
    void failed(Request request, String why);
  }

  /**
   * A reader.
   *
   * @param reading runs what reads a file
   * @param dispatch runs what comes of it in the thread that uses this object
   */
  MomentReader(Executor reading, Executor dispatch) {
    this.reading = reading;
    this.dispatch = dispatch;
  }

  /** One for a window. */
  static MomentReader ofWindow() {
    return new MomentReader(
        task -> Thread.ofVirtual().name("moment").start(task), EventQueue::invokeLater);
  }

  /** Reads a moment when those before are done, unless another one is asked for until then. */
  void read(Request wanted, Listener listener) {
    next = Optional.of(wanted);
    begin(listener);
  }

  /** Reads nothing more of what was asked for; what is being read may still come. */
  void forget() {
    next = Optional.empty();
  }

  private void begin(Listener listener) {
    if (busy || next.isEmpty()) {
      return;
    }
    Request request = next.get();
    next = Optional.empty();
    busy = true;
    reading.execute(
        () -> {
          Runnable told = told(request, listener);
          dispatch.execute(
              () -> {
                busy = false;
                told.run();
                begin(listener);
              });
        });
  }

  private static Runnable told(Request request, Listener listener) {
    try {
      ControllerState state = request.recording().at(request.moment());
      return () -> listener.read(request, state);
    } catch (UncheckedIOException e) {
      return () -> listener.failed(request, e.getCause().getMessage());
    } catch (RuntimeException | Error fault) {
      Faults.report(fault);
      return () -> listener.failed(request, "internal error, " + fault);
    }
  }
}
