package org.pendant.gui.log;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.function.LongFunction;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.state.ControllerState;
import org.pendant.gui.session.FrameListener;

/**
 * Keeps the newest messages of every frame until the screen asks for them, so that none is lost
 * while it is hidden. The frame loop alone writes; any thread reads. Messages are numbered anew,
 * from 1 and without gaps, also across a restart of the controller.
 */
final class LogMailbox implements FrameListener {
  private final AtomicReferenceArray<LogEntry> ring;
  private final LongFunction<List<LogEntry>> controllerLog;
  private volatile long newest;

  private long lastFrame;
  private long lastNumber;

  /**
   * An empty mailbox.
   *
   * @param capacity how many messages it keeps
   * @param controllerLog gives what the controller still keeps after a number of its own
   */
  LogMailbox(int capacity, LongFunction<List<LogEntry>> controllerLog) {
    ring = new AtomicReferenceArray<>(capacity);
    this.controllerLog = controllerLog;
  }

  @Override
  public void frame(ControllerState state) {
    if (state.frame() < lastFrame) {
      // another controller has been switched on
      lastNumber = 0;
    }
    lastFrame = state.frame();
    if (state.newestEntry() > lastNumber) {
      boolean complete = lastNumber + state.newEntries().size() == state.newestEntry();
      (complete ? state.newEntries() : controllerLog.apply(lastNumber)).forEach(this::put);
      lastNumber = state.newestEntry();
    }
  }

  private void put(LogEntry entry) {
    long number = newest + 1;
    ring.set(
        (int) (number % ring.length()),
        new LogEntry(number, entry.timeS(), entry.level(), entry.origin(), entry.text()));
    newest = number;
  }

  /** The number of the newest message, 0 for none. */
  long newest() {
    return newest;
  }

  /** Messages after number {@code number} that are still kept, oldest first. */
  List<LogEntry> since(long number) {
    long last = newest;
    List<LogEntry> found = new ArrayList<>();
    for (long each = Math.max(number, last - ring.length()) + 1; each <= last; each++) {
      LogEntry entry = ring.get((int) (each % ring.length()));
      // a slow reader may be overtaken: then a newer one stands in this place
      if (entry != null && entry.number() == each) {
        found.add(entry);
      }
    }
    return found;
  }
}
