package org.pendant.testing.remote;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.pendant.controller.safety.SafetyMode;

/**
 * Target view: what the test that runs sees of its target. Owned by the thread that drives the
 * test.
 */
public final class TargetView {
  /** Lines that are kept; of more, the oldest go. */
  private static final int MAX_LINES = 10_000;

  private TargetState state = new TargetState(Map.of());
  private final List<String> lines = new ArrayList<>();
  private final Map<Long, String> popups = new HashMap<>();
  private TargetVariables variables = TargetVariables.NONE;

  /** Variables that were begun to be told by then are of an earlier program. */
  private long earlier = Long.MAX_VALUE;

  /** Forgets everything, for the next test. */
  public void clear() {
    state = new TargetState(Map.of());
    lines.clear();
    popups.clear();
    variables = TargetVariables.NONE;
    programSent();
  }

  /** A program was sent; what is told of variables until it starts is not about it. */
  public void programSent() {
    earlier = Long.MAX_VALUE;
  }

  /** The program that was sent has started. */
  public void programStarted() {
    earlier = variables.begun();
  }

  /** The target has told this of variables. */
  public void see(TargetVariables now) {
    variables = now;
  }

  /** What the target has told of variables. */
  public TargetVariables variables() {
    return variables;
  }

  /** Whether all of them were told of this program, and after {@code begun} times. */
  public boolean variablesSince(long begun) {
    return variables.whole() > Math.max(begun, earlier);
  }

  /** A state has come. */
  public void see(TargetState now) {
    state = now;
  }

  /** The newest state. */
  public TargetState state() {
    return state;
  }

  /** A line of the log has come. */
  public void addLine(String line) {
    if (lines.size() == MAX_LINES) {
      lines.removeFirst();
    }
    lines.add(line);
  }

  /** Lines of the log since the test began. */
  public List<String> lines() {
    return lines;
  }

  /** Popups on the screen, by their numbers. */
  public Map<Long, String> popups() {
    return popups;
  }

  /** The safety mode in small letters. */
  public String safetyMode() {
    return nameOfSafety(state.safety());
  }

  /** Whether the safety functions have stopped the arm. */
  public boolean stopped() {
    return state.safety() > SafetyMode.REDUCED.code();
  }

  /** The name of a safety mode in small letters. */
  public static String nameOfSafety(int code) {
    for (SafetyMode each : SafetyMode.values()) {
      if (each.code() == code) {
        return each.name().toLowerCase(Locale.ROOT);
      }
    }
    return "mode " + code;
  }
}
