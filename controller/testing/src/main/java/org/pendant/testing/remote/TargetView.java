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

  /** Forgets everything, for the next test. */
  public void clear() {
    state = new TargetState(Map.of());
    lines.clear();
    popups.clear();
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
