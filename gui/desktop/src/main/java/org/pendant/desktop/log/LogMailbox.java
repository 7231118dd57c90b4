package org.pendant.desktop.log;

import static org.pendant.desktop.log.LogTexts.text;

import java.time.Instant;
import java.time.InstantSource;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.LongFunction;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.session.CellListener;
import org.pendant.desktop.session.FrameListener;
import org.pendant.desktop.session.SessionMember;
import org.pendant.language.source.ByteText;
import org.pendant.script.vm.RecentEntries;

/**
 * Log mailbox: keeps the newest messages of every frame, what changes in it, and what the window
 * tells, until the screen asks for them, so that none is lost while it is hidden. Any thread reads.
 * Messages of all controllers of a cell are in it, each with the name of its own. They are numbered
 * anew, from 1 and without gaps, also across a restart of the controller.
 */
final class LogMailbox implements FrameListener, CellListener {
  /** The longest text of a message, bytes: all that are kept must find room. */
  static final int MAX_TEXT = 4096;

  private final RecentEntries<Mail> recent;
  private final LongFunction<List<LogEntry>> controllerLog;
  private final InstantSource clock;
  private volatile double timeS;

  /** What has been seen of each controller, by its name; the frame loop alone. */
  private final Map<String, Followed> followed = new HashMap<>();

  /** A message as it came; it becomes text for people when the user asks for it. */
  private record Mail(
      long number, Instant wall, LogSource source, LogEntry entry, String controller) {}

  /**
   * An empty mailbox.
   *
   * @param capacity how many messages it keeps
   * @param controllerLog gives what the controller still keeps after a number of its own
   * @param clock tells when a message arrives
   */
  LogMailbox(int capacity, LongFunction<List<LogEntry>> controllerLog, InstantSource clock) {
    recent =
        new RecentEntries<>(
            capacity, LogStore.MAX_BYTES, Mail::number, mail -> mail.entry().text().length());
    this.controllerLog = controllerLog;
    this.clock = clock;
  }

  @Override
  public void frame(ControllerState state) {
    followed("", controllerLog).frame(state);
  }

  @Override
  public void frame(SessionMember member, ControllerState state) {
    Followed known = followed.get(member.name());
    if (known == null || known.member != member) {
      known = followed(member.name(), number -> member.robot().logSince(number));
      known.member = member;
    }
    known.frame(state);
  }

  private Followed followed(String controller, LongFunction<List<LogEntry>> log) {
    Followed known = followed.computeIfAbsent(controller, Followed::new);
    known.log = log;
    return known;
  }

  /** A controller that is followed. */
  private final class Followed {
    private final String controller;
    private final StateChanges changes = new StateChanges();
    private SessionMember member;
    private LongFunction<List<LogEntry>> log = number -> List.of();
    private long lastFrame;
    private long lastNumber;

    Followed(String controller) {
      this.controller = controller;
    }

    void frame(ControllerState state) {
      timeS = state.timeS();
      if (state.frame() < lastFrame) {
        // another one has been switched on; what one said that repeats the run is here already
        lastNumber = state.frame() == 1 ? 0 : state.newestEntry() - state.newEntries().size();
      }
      lastFrame = state.frame();
      if (state.newestEntry() > lastNumber) {
        List<LogEntry> fresh = state.newEntries();
        boolean complete = lastNumber + fresh.size() == state.newestEntry();
        (complete ? fresh : log.apply(lastNumber)).forEach(this::take);
        lastNumber = state.newestEntry();
      }
      changes.in(state).forEach(text -> put(LogSource.ROBOT, entry(text), controller));
    }

    private void take(LogEntry entry) {
      long missed = entry.number() - lastNumber - 1;
      if (missed > 0) {
        put(LogSource.WINDOW, entry(text("linesOfTheControllerWereNot", missed)), controller);
      }
      put(LogSource.of(entry.origin()), entry.shortened(MAX_TEXT), controller);
      lastNumber = entry.number();
    }
  }

  /** Keeps what the window tells; the dispatch thread. */
  void told(String text) {
    put(LogSource.WINDOW, text);
  }

  /** Keeps what the robot or a client of it did; any thread. */
  void happened(String text) {
    put(LogSource.ROBOT, text);
  }

  private void put(LogSource source, String text) {
    put(source, entry(text), "");
  }

  private LogEntry entry(String text) {
    return new LogEntry(
        0, timeS, LogEntry.Level.INFO, LogEntry.Origin.CONTROLLER, ByteText.asBytes(text));
  }

  /** The frame loop, the dispatch thread and those of clients write, all rarely. */
  private synchronized void put(LogSource source, LogEntry entry, String controller) {
    recent.add(new Mail(recent.newest() + 1, clock.instant(), source, entry, controller));
  }

  /** The number of the newest message, 0 for none. */
  long newest() {
    return recent.newest();
  }

  /** Messages after number {@code number} that are still kept, oldest first. */
  List<LogLine> since(long number) {
    return recent.between(number, Long.MAX_VALUE).stream()
        .map(
            mail ->
                LogLine.of(
                    mail.number(), mail.wall(), mail.source(), mail.entry(), mail.controller()))
        .toList();
  }
}
