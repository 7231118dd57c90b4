package org.pendant.controller.message;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.function.Supplier;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.controller.message.LogEntry.Origin;

/**
 * The log. The frame loop alone writes; {@link #since} and {@link #newest} may be called by any
 * thread at any time.
 */
public final class MessageLog {
  /** How many of the newest entries can still be asked for. */
  public static final int KEPT = 4096;

  private final AtomicReferenceArray<LogEntry> ring = new AtomicReferenceArray<>(KEPT);
  private volatile long newest;

  private List<LogEntry> thisFrame = new ArrayList<>();
  private final Set<String> warned = new HashSet<>();
  private double timeS;
  private Supplier<Optional<LogEntry.Place>> where = Optional::empty;

  /** Entries written from now on carry this time, s. */
  public void setTime(double timeS) {
    this.timeS = timeS;
  }

  /**
   * Entries written from now on carry a place: of what programs write and of all that is worse than
   * an information.
   *
   * @param where what a program is at just now, if one runs
   */
  public void placeBy(Supplier<Optional<LogEntry.Place>> where) {
    this.where = where;
  }

  /** A line that a program writes. */
  public void script(String text) {
    add(Level.INFO, Origin.SCRIPT, "", text, where.get());
  }

  public void info(String text) {
    add(Level.INFO, Origin.CONTROLLER, "", text, Optional.empty());
  }

  public void warning(String text) {
    add(Level.WARNING, Origin.CONTROLLER, "", text, where.get());
  }

  public void error(String text) {
    add(Level.ERROR, Origin.CONTROLLER, "", text, where.get());
  }

  /**
   * An error of something that is over already.
   *
   * @param place where it was
   */
  public void error(String code, String text, LogEntry.Place place) {
    add(Level.ERROR, Origin.CONTROLLER, code, text, Optional.of(place));
  }

  /**
   * What a safety function says.
   *
   * @param code such as {@code C153A2}; empty for none
   */
  public void safety(Level level, String code, String text) {
    Optional<LogEntry.Place> place = level == Level.INFO ? Optional.empty() : where.get();
    add(level, Origin.SAFETY, code, text, place);
  }

  /** What comes from outside by a protocol. */
  public void protocol(Level level, String text) {
    add(level, Origin.PROTOCOL, "", text, Optional.empty());
  }

  /**
   * Why a program ended by itself.
   *
   * @param code of the error
   * @param place where
   */
  public void ending(String code, String text, Optional<LogEntry.Place> place) {
    add(Level.ERROR, Origin.ENDING, code, text, place);
  }

  /** A mistake of ours, with all there is to know about it. */
  public void internalError(Throwable cause) {
    StringWriter trace = new StringWriter();
    cause.printStackTrace(new PrintWriter(trace));
    error("internal error: " + trace);
  }

  /** Warns, unless the same text was a warning of this kind since {@link #programStarted}. */
  public void warnOnce(String text) {
    if (warned.add(text)) {
      warning(text);
    }
  }

  /** A program starts: warnings given once are due again. */
  public void programStarted() {
    warned.clear();
  }

  /** What was written since the last call; for the frame's snapshot. */
  public List<LogEntry> takeNew() {
    if (thisFrame.isEmpty()) {
      return List.of();
    }
    List<LogEntry> taken = List.copyOf(thisFrame);
    thisFrame = new ArrayList<>();
    return taken;
  }

  /** The number of the newest entry, 0 when there is none. */
  public long newest() {
    return newest;
  }

  /** Entries after number {@code number} that are still kept, oldest first. */
  public List<LogEntry> since(long number) {
    long last = newest;
    List<LogEntry> found = new ArrayList<>();
    for (long each = Math.max(number, last - KEPT) + 1; each <= last; each++) {
      LogEntry entry = ring.get((int) (each % KEPT));
      // a slow reader may be overtaken: then a newer entry stands in this place
      if (entry != null && entry.number() == each) {
        found.add(entry);
      }
    }
    return found;
  }

  private void add(
      Level level, Origin origin, String code, String text, Optional<LogEntry.Place> place) {
    long number = newest + 1;
    LogEntry entry = new LogEntry(number, timeS, level, origin, code, text, place);
    ring.set((int) (number % KEPT), entry);
    thisFrame.add(entry);
    newest = number;
  }
}
