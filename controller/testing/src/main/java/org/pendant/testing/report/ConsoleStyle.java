package org.pendant.testing.report;

import java.util.Set;
import org.pendant.testing.TestStatus;

/**
 * Console style: how much a console report tells, and what the terminal can do.
 *
 * @param detail how much
 * @param features what is asked for beyond plain lines
 */
public record ConsoleStyle(Detail detail, Set<Feature> features) {
  /** How much is told. */
  public enum Detail {
    /** Red tests, and how many there were. */
    QUIET,
    /** A line for each file as well. */
    NORMAL,
    /** A line for each test as well. */
    VERBOSE
  }

  /** What is asked for beyond plain lines. */
  public enum Feature {
    /** Colours, by ANSI escape sequences. */
    COLOURS,
    /** Marks of ASCII only, for terminals that show no UTF-8. */
    ASCII,
    /** A line of progress that is written over and over, and each line as soon as it is known. */
    TERMINAL,
    /** How long it took by the wall clock, as the last line; no two runs have the same then. */
    WALL_TIME
  }

  private static final int RED = 31;
  private static final int GREEN = 32;
  private static final int YELLOW = 33;
  private static final int FAINT = 2;

  public ConsoleStyle {
    features = Set.copyOf(features);
  }

  /** A style with these features. */
  public static ConsoleStyle of(Detail detail, Feature... features) {
    return new ConsoleStyle(detail, Set.of(features));
  }

  boolean has(Feature feature) {
    return features.contains(feature);
  }

  /** The mark of a status, in its colour, with a blank behind it. */
  String mark(TestStatus status) {
    boolean ascii = has(Feature.ASCII);
    return switch (status) {
      case PASSED -> coloured(GREEN, ascii ? "ok  " : "✓") + " ";
      case FAILED, ERROR, TIMED_OUT -> coloured(RED, ascii ? "FAIL" : "✗") + " ";
      case SKIPPED -> coloured(YELLOW, ascii ? "skip" : "○") + " ";
    };
  }

  String red(String text) {
    return coloured(RED, text);
  }

  String green(String text) {
    return coloured(GREEN, text);
  }

  String faint(String text) {
    return coloured(FAINT, text);
  }

  private String coloured(int code, String text) {
    return has(Feature.COLOURS) ? "\u001b[" + code + "m" + text + "\u001b[0m" : text;
  }
}
