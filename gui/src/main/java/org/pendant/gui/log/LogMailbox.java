package org.pendant.gui.log;

import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.function.LongFunction;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.state.ControllerState;
import org.pendant.gui.session.FrameListener;
import org.pendant.language.source.ByteText;

/**
 * Keeps the newest messages of every frame, and what the window tells, until the screen asks for
 * them, so that none is lost while it is hidden. Any thread reads. Messages are numbered anew, from
 * 1 and without gaps, also across a restart of the controller.
 */
final class LogMailbox implements FrameListener {
  private final AtomicReferenceArray<Mail> ring;
  private final LongFunction<List<LogEntry>> controllerLog;
  private final InstantSource clock;
  private volatile long newest;
  private volatile double timeS;

  private long lastFrame;
  private long lastNumber;

  /** A message as it came; it becomes text for people when somebody asks for it. */
  private record Mail(long number, Instant wall, LogSource source, LogEntry entry) {}

  /**
   * An empty mailbox.
   *
   * @param capacity how many messages it keeps
   * @param controllerLog gives what the controller still keeps after a number of its own
   * @param clock tells when a message arrives
   */
  LogMailbox(int capacity, LongFunction<List<LogEntry>> controllerLog, InstantSource clock) {
    ring = new AtomicReferenceArray<>(capacity);
    this.controllerLog = controllerLog;
    this.clock = clock;
  }

  @Override
  public void frame(ControllerState state) {
    if (state.frame() < lastFrame) {
      // another controller has been switched on; what one said that repeats the run is here already
      lastNumber = state.frame() == 1 ? 0 : state.newestEntry() - state.newEntries().size();
    }
    lastFrame = state.frame();
    timeS = state.timeS();
    if (state.newestEntry() > lastNumber) {
      boolean complete = lastNumber + state.newEntries().size() == state.newestEntry();
      (complete ? state.newEntries() : controllerLog.apply(lastNumber))
          .forEach(entry -> put(LogSource.of(entry.origin()), entry));
      lastNumber = state.newestEntry();
    }
  }

  /** Keeps what the window tells; the dispatch thread. */
  void told(String text) {
    put(
        LogSource.WINDOW,
        new LogEntry(
            0, timeS, LogEntry.Level.INFO, LogEntry.Origin.CONTROLLER, ByteText.asBytes(text)));
  }

  /** The frame loop and the dispatch thread write, both rarely. */
  private synchronized void put(LogSource source, LogEntry entry) {
    long number = newest + 1;
    ring.set((int) (number % ring.length()), new Mail(number, clock.instant(), source, entry));
    newest = number;
  }

  /** The number of the newest message, 0 for none. */
  long newest() {
    return newest;
  }

  /** Messages after number {@code number} that are still kept, oldest first. */
  List<LogLine> since(long number) {
    long last = newest;
    List<LogLine> found = new ArrayList<>();
    for (long each = Math.max(number, last - ring.length()) + 1; each <= last; each++) {
      Mail mail = ring.get((int) (each % ring.length()));
      // a slow reader may be overtaken: then a newer one stands in this place
      if (mail != null && mail.number() == each) {
        found.add(LogLine.of(each, mail.wall(), mail.source(), mail.entry()));
      }
    }
    return found;
  }
}
