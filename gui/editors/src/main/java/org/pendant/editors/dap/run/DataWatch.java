package org.pendant.editors.dap.run;

import static org.pendant.editors.dap.run.DebuggedRunTexts.text;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.ByteText;
import org.pendant.script.debug.Debugger;
import org.pendant.script.debug.HitRule;
import org.pendant.script.debug.Variable;
import org.pendant.script.value.ScriptError;

/**
 * Data watch: holds a program when values have changed, looked at before each frame. The thread
 * that drives the robot looks; another one may take what was found.
 */
public final class DataWatch implements DebuggedRobot.FrameWatch {

  private final Supplier<ControllerState> robot;
  private final List<Watched> all;
  private final Map<Watched, Optional<String>> last = new HashMap<>();
  private final Map<Watched, Integer> hits = new HashMap<>();
  private volatile boolean afresh;
  private volatile List<Change> changes = List.of();

  /** Reads a value. */
  @FunctionalInterface
  public interface Reader {
    /**
     * Its text now.
     *
     * @throws ScriptError where there is none
     */
    String read(Debugger debugger, ControllerState state) throws ScriptError;
  }

  /**
   * A value that is watched.
   *
   * @param id by which the client knows it
   * @param name that people read
   * @param condition an expression that must be true after a change; empty text for none
   * @param hits which changes hold the program
   */
  public record Watched(int id, String name, Reader reader, String condition, HitRule hits) {}

  /** A change that has held the program. */
  public record Change(int id, String words) {}

  /** A watch of values of a robot. */
  public DataWatch(Supplier<ControllerState> robot, List<Watched> all) {
    this.robot = robot;
    this.all = List.copyOf(all);
  }

  /** The value of an expression where all global variables can be seen. */
  public static Reader expression(String expression) {
    String bytes = ByteText.asBytes(expression);
    return (debugger, state) -> ByteText.decoded(value(debugger, bytes).text());
  }

  private static Variable value(Debugger debugger, String bytes) throws ScriptError {
    return debugger.evaluate(Debugger.MAIN, Debugger.OUTERMOST, bytes);
  }

  /** What somebody changes while the program is held is no change. */
  public void beginAfresh() {
    afresh = true;
  }

  /** The changes that have held the program, once. */
  public List<Change> take() {
    List<Change> found = changes;
    changes = List.of();
    return found;
  }

  @Override
  public void look(Debugger debugger) {
    ControllerState state = robot.get();
    List<Change> found = new ArrayList<>();
    boolean silent = afresh;
    afresh = false;
    for (Watched each : all) {
      Optional<String> now = read(each, debugger, state);
      Optional<String> before = last.put(each, now);
      if (before != null && !before.equals(now) && !silent && counts(each, debugger)) {
        found.add(new Change(each.id(), words(each.name(), before, now)));
      }
    }
    if (!found.isEmpty()) {
      changes = List.copyOf(found);
      hold(debugger);
    }
  }

  private static String words(String name, Optional<String> before, Optional<String> now) {
    if (before.isEmpty()) {
      return text("gotValue", name, now.orElseThrow());
    }
    return now.isEmpty()
        ? text("lostValue", name, before.get())
        : text("changed", name, before.get(), now.get());
  }

  /** Empty before it is assigned, and while no program runs. */
  private static Optional<String> read(Watched each, Debugger debugger, ControllerState state) {
    try {
      return Optional.of(each.reader().read(debugger, state));
    } catch (ScriptError | IllegalArgumentException e) {
      return Optional.empty();
    }
  }

  private boolean counts(Watched each, Debugger debugger) {
    return holds(each, debugger) && each.hits().counts(hits.merge(each, 1, Integer::sum));
  }

  private static boolean holds(Watched each, Debugger debugger) {
    if (each.condition().isEmpty()) {
      return true;
    }
    try {
      return value(debugger, ByteText.asBytes(each.condition())).text().equals("True");
    } catch (ScriptError | IllegalArgumentException e) {
      // what cannot be computed is not true
      return false;
    }
  }

  private void hold(Debugger debugger) {
    try {
      debugger.pause();
    } catch (IllegalArgumentException e) {
      // the program has ended in the frame that made the change
      changes = List.of();
    }
  }
}
