package org.pendant.controller.message;

import static org.pendant.controller.message.MessageTexts.text;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.controller.message.LogEntry.Origin;
import org.pendant.script.function.Call;
import org.pendant.script.function.ScriptPlace;
import org.pendant.script.vm.RecentEntries;

/**
 * Message log of the controller. The frame loop alone writes; {@link #since} and {@link #newest}
 * may be called by any thread at any time. What it takes is bounded: in lines and bytes that are
 * kept, in the length of a line, and in what programs and clients may write in a frame.
 */
public final class MessageLog {
  /** How many of the newest entries can still be asked for, where their texts are short. */
  public static final int KEPT = 16_384;

  /** What the texts of the entries that can be asked for take together, at most. */
  public static final int KEPT_BYTES = 16 << 20;

  /** The longest text of an entry, bytes; a longer one is cut, and its end says so. */
  public static final int MAX_TEXT = Call.MAX_TEXT;

  /** Entries of a frame, errors not counted; more are left out, and one entry says how many. */
  public static final int MAX_IN_FRAME = 4096;

  /** What the texts of a frame's entries take together, at most; as {@link #MAX_IN_FRAME}. */
  public static final int MAX_BYTES_IN_FRAME = 8 << 20;

  /** Different warnings of a program that are given once; more are not given at all. */
  private static final int MAX_WARNED = 1000;

  private final RecentEntries<LogEntry> recent =
      new RecentEntries<>(KEPT, KEPT_BYTES, LogEntry::number, each -> each.text().length());
  private final Set<String> warned = new HashSet<>();
  private long taken;
  private int linesOfFrame;
  private long bytesOfFrame;
  private long leftOut;
  private double timeS;
  private Supplier<Optional<ScriptPlace>> where = Optional::empty;

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
  public void placeBy(Supplier<Optional<ScriptPlace>> where) {
    this.where = where;
  }

  /** A line that a program writes. */
  public void script(String text) {
    add(Level.INFO, Origin.SCRIPT, "", text, where.get());
  }

  public void info(String text) {
    add(Level.INFO, Origin.CONTROLLER, "", text, Optional.empty());
  }

  /** What a breakpoint writes instead of stopping a program. */
  public void logpoint(String text) {
    add(Level.INFO, Origin.CONTROLLER, "", text, where.get());
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
  public void error(String code, String text, ScriptPlace place) {
    add(Level.ERROR, Origin.CONTROLLER, code, text, Optional.of(place));
  }

  /**
   * What a safety function says.
   *
   * @param code such as {@code C153A2}; empty for none
   */
  public void safety(Level level, String code, String text) {
    Optional<ScriptPlace> place = level == Level.INFO ? Optional.empty() : where.get();
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
  public void ending(String code, String text, Optional<ScriptPlace> place) {
    add(Level.ERROR, Origin.ENDING, code, text, place);
  }

  /** A mistake of ours, with all there is to know about it. */
  public void internalError(Throwable cause) {
    StringWriter trace = new StringWriter();
    cause.printStackTrace(new PrintWriter(trace));
    error(text("internalError", trace));
  }

  /** Warns, unless the same text was a warning of this kind since {@link #programStarted}. */
  public void warnOnce(String text) {
    if (warned.size() < MAX_WARNED && warned.add(text)) {
      warning(text);
    }
  }

  /** A program starts: warnings given once are due again. */
  public void programStarted() {
    warned.clear();
  }

  /** What was written since the last call, for the frame's snapshot; another frame begins. */
  public LogLines takeNew() {
    if (leftOut > 0) {
      long count = leftOut;
      leftOut = 0;
      linesOfFrame = 0;
      bytesOfFrame = 0;
      add(
          Level.WARNING,
          Origin.CONTROLLER,
          "",
          MessageTexts.text(count == 1 ? "lineLeftOut" : "linesLeftOut", count),
          Optional.empty());
    }
    linesOfFrame = 0;
    bytesOfFrame = 0;
    long last = recent.newest();
    if (last == taken) {
      return LogLines.NONE;
    }
    LogLines lines = new LogLines.InLog(this, taken, last);
    taken = last;
    return lines;
  }

  /** The number of the newest entry, 0 when there is none. */
  public long newest() {
    return recent.newest();
  }

  /**
   * Entries after number {@code number} that are still kept, oldest first. Numbers have no gaps: a
   * reader that falls behind sees by the first of them how many it has missed.
   */
  public List<LogEntry> since(long number) {
    return between(number, Long.MAX_VALUE);
  }

  /** As {@link #since}, up to number {@code last}. */
  List<LogEntry> between(long number, long last) {
    return recent.between(number, last);
  }

  private void add(
      Level level, Origin origin, String code, String text, Optional<ScriptPlace> place) {
    LogEntry entry =
        new LogEntry(recent.newest() + 1, timeS, level, origin, code, text, place)
            .shortened(MAX_TEXT);
    linesOfFrame++;
    bytesOfFrame += entry.text().length();
    boolean fits = linesOfFrame <= MAX_IN_FRAME && bytesOfFrame <= MAX_BYTES_IN_FRAME;
    if (fits || level == Level.ERROR) {
      recent.add(entry);
    } else {
      leftOut++;
    }
  }
}
