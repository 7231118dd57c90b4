package org.pendant.testing.run;

import static org.pendant.testing.run.TestRunTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CompletableFuture;
import java.util.function.Function;
import org.pendant.controller.Cell;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.Frames;
import org.pendant.controller.box.CellPlan;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.value.ScriptError;
import org.pendant.script.vm.Program;
import org.pendant.testing.TestPlace;
import org.pendant.testing.TestResult;
import org.pendant.testing.run.TestPlan.Chosen;
import org.pendant.testing.source.TestScene;

/**
 * Debugged test: one test in a controller that somebody else drives, at any pace, with a debugger,
 * and with those that share a cell with it. It does in the same frames what it does without one:
 * where the debugger has paused the program, the frame has not ended and no time passes. Used by
 * the thread that drives.
 */
public final class DebuggedTest {
  private final Chosen chosen;
  private final TestRun run;
  private final Program program;
  private long beganNs;
  private long seenFrame;
  private boolean over;

  private DebuggedTest(Chosen chosen, TestRun run, Program program) {
    this.chosen = chosen;
    this.run = run;
    this.program = program;
  }

  /**
   * Prepares a test; nothing has run.
   *
   * @throws NotDebugged if the debugger cannot see what it runs
   */
  static DebuggedTest of(Chosen chosen, TestRun run) throws NotDebugged {
    Optional<String> broken = run.broken();
    if (broken.isPresent()) {
      throw new NotDebugged(broken.get());
    }
    if (!chosen.test().watches()) {
      return new DebuggedTest(chosen, run, chosen.file().program());
    }
    List<String> starts =
        chosen.file().starts().getOrDefault(chosen.test().id().function(), List.of());
    if (starts.isEmpty()) {
      throw new NotDebugged(text("computedName"));
    }
    try {
      Program first = chosen.programs().load(starts.getFirst());
      if (chosen.programs().isTree(first)) {
        throw new NotDebugged(text("treeNotDebugged", starts.getFirst()));
      }
      return new DebuggedTest(chosen, run, first);
    } catch (ScriptError e) {
      throw new NotDebugged(e.getMessage());
    }
  }

  /** A test cannot be debugged; the message says why, for people. */
  public static final class NotDebugged extends Exception {
    private static final long serialVersionUID = 1;

    NotDebugged(String why) {
      super(why);
    }
  }

  /** The controller that it runs on, which has run no frame. */
  public Controller controller() {
    return run.controller();
  }

  /** What is to be driven: the controller, or the cell that it shares with others. */
  public Frames frames() {
    return cell().<Frames>map(cell -> cell).orElse(run.controller());
  }

  /** The cell whose first controller it is; empty for one that is alone. */
  public Optional<Cell> cell() {
    return run.cell().map(TestCell::cell);
  }

  /** Of {@link #cell}; empty for a controller that is alone. */
  public Optional<CellPlan> plan() {
    return cell().flatMap(_ -> chosen.test().scene()).map(TestScene::plan);
  }

  /** What it was switched on with. */
  public ControllerOptions options() {
    return run.options();
  }

  /** Whether it starts a program, so that the debugger sees that one. */
  public boolean watches() {
    return chosen.test().watches();
  }

  /** What the debugger sees: the test itself, or the program that it starts. */
  public Program program() {
    return program;
  }

  /** The file that {@link #program} is in: its own, or that of what it starts. */
  public String file() {
    return program.source().name();
  }

  /** The line of {@link #program} that its definition begins on; empty if it starts a program. */
  public OptionalInt firstLine() {
    return chosen.test().watches()
        ? OptionalInt.empty()
        : OptionalInt.of(chosen.test().place().line());
  }

  /** The line of {@link #file} that a line of {@link #program} is; 0 for one of another file. */
  public int lineInFile(int line) {
    if (chosen.test().watches()) {
      return line;
    }
    TestPlace place = chosen.file().composition().placeOfLine(line, chosen.test().id().function());
    return place.file().equals(file()) && place.line() == line ? line : 0;
  }

  /**
   * Begins it.
   *
   * @param submit takes its commands from now on
   */
  public void begin(Function<Command, CompletableFuture<Reply>> submit) {
    beganNs = System.nanoTime();
    run.controller().determinism().taint("a test is debugged, which its journal knows nothing of");
    run.submitBy(submit);
    run.begin();
    run.prepare();
  }

  /**
   * The driver has gone on: by a frame, or by commands between two of them.
   *
   * @return what has come of the test, once
   */
  public Optional<TestResult> after(ControllerState state) {
    if (over || state.debug().held() || state.frame() == seenFrame) {
      return Optional.empty();
    }
    seenFrame = state.frame();
    run.see(state);
    Optional<TestOutcome> outcome = run.outcome(state);
    if (outcome.isEmpty()) {
      run.prepare();
      return Optional.empty();
    }
    over = true;
    return Optional.of(run.result(outcome.get(), state, beganNs));
  }
}
