package org.pendant.desktop.tests;

import static org.pendant.desktop.tests.TestsTexts.text;

import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.pendant.controller.Cell;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.Pace;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.debug.RunLines;
import org.pendant.desktop.debug.RunScript;
import org.pendant.desktop.session.CellSetup;
import org.pendant.desktop.session.FrameListener;
import org.pendant.desktop.session.ProgramControls;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.session.SavedProgram;
import org.pendant.desktop.session.SessionMember;
import org.pendant.desktop.session.SwitchListener;
import org.pendant.kit.background.Background;
import org.pendant.project.program.script.GeneratedNames;
import org.pendant.testing.TestResult;
import org.pendant.testing.run.DebuggedTest;
import org.pendant.testing.run.TestPlan;
import org.pendant.testing.run.TestRunner;
import org.pendant.testing.source.TestCase;

/**
 * Test debugger: runs one test in the window, with its debugger. The controller of the test takes
 * the place of that of the window until the test has ended.
 */
final class TestDebugger implements SwitchListener {
  private final RobotSession session;
  private final Programs programs;
  private final BiConsumer<ProgramDocument, RunScript> starts;
  private final Consumer<String> tell;
  private final Consumer<TestResult> ended;

  /** What people had before; empty while no test is debugged. */
  private Optional<Own> own = Optional.empty();

  private Phase phase = Phase.COMING;

  /** The session is being given another controller here, not by others. */
  private volatile boolean switching;

  /** How far it is with a test. */
  private enum Phase {
    COMING,
    RUNNING,
    /** It has been given up, or has ended, and the other robot comes back. */
    LEAVING
  }

  /**
   * What comes back: the robot, or all controllers of a cell.
   *
   * @param options of a robot that is alone
   * @param shown the name of the controller that was shown
   * @param speedFractions of each controller, in their order
   */
  private record Own(
      TestCase test,
      Optional<CellSetup> cell,
      ControllerOptions options,
      String shown,
      List<Double> speedFractions,
      Pace pace) {}

  /** A test that is about to begin, and the file that the debugger shows. */
  private record Prepared(DebuggedTest test, SavedProgram file) {}

  /**
   * A debugger of tests; it hears when the session gets another controller.
   *
   * @param starts told before a program starts that is shown as this one
   * @param ended told what has come of a test
   */
  TestDebugger(
      RobotSession session,
      Programs programs,
      BiConsumer<ProgramDocument, RunScript> starts,
      Consumer<String> tell,
      Consumer<TestResult> ended) {
    this.session = session;
    this.programs = programs;
    this.starts = starts;
    this.tell = tell;
    this.ended = ended;
    session.addSwitchListener(this);
  }

  /** The test that is being debugged, or about to be. */
  Optional<TestCase> test() {
    return own.map(Own::test);
  }

  /** Runs a test; refusals are told. */
  void debug(TestSetup setup, TestCase test, long seed) {
    if (own.isPresent()) {
      tell.accept(text("isBeingDebugged", own.get().test().id().name()));
      return;
    }
    List<ControllerState> states = session.members().stream().map(SessionMember::state).toList();
    if (states.stream().anyMatch(state -> ProgramControls.of(state).canStop())) {
      tell.accept(text("notDebuggedAProgramRunsStop"));
      return;
    }
    own =
        Optional.of(
            new Own(
                test,
                session.cell(),
                session.options().withStart(session.state().arm().actualPositionRad()),
                session.shown().name(),
                states.stream().map(state -> state.arm().speedFraction()).toList(),
                session.pace()));
    phase = Phase.COMING;
    Background.run(
        () -> prepare(setup, test, seed),
        this::begin,
        failed -> {
          own = Optional.empty();
          tell.accept(text("cannotBeDebugged", test.id().name(), failed.getMessage()));
        });
  }

  private Prepared prepare(TestSetup setup, TestCase test, long seed) throws IOException {
    TestRunner runner =
        new TestRunner(
            setup.files(),
            TestJob.settings(setup, seed),
            each -> each.id().equals(test.id()),
            _ -> {},
            setup.files().goldens(false),
            Optional.empty());
    TestPlan plan = runner.plan(List.of(test.id().file()));
    if (!plan.broken().isEmpty()) {
      throw new IOException(plan.broken().getFirst().problems().getFirst());
    }
    if (plan.tests().isEmpty()) {
      throw new IOException(text("itIsNoLongerIn", test.id().file()));
    }
    try {
      DebuggedTest debugged = runner.debug(plan, test.id());
      Path file = Path.of(setup.files().folder()).resolve(debugged.file()).normalize();
      Prepared prepared = new Prepared(debugged, SavedProgram.read(file));
      switching = true;
      lend(debugged);
      return prepared;
    } catch (DebuggedTest.NotDebugged e) {
      throw new IOException(e.getMessage(), e);
    } finally {
      switching = false;
    }
  }

  private void lend(DebuggedTest debugged) {
    FrameListener guest = state -> frame(debugged, state);
    Optional<Cell> cell = debugged.cell();
    if (cell.isPresent()) {
      List<ControllerOptions> options =
          cell.get().members().stream().map(Cell.Member::options).toList();
      session.lend(new CellSetup(debugged.plan().orElseThrow(), options), cell.get(), guest);
    } else {
      session.lend(debugged.options(), debugged.controller(), guest);
    }
  }

  /** Breakpoints come first, then the test, then robot time. */
  private void begin(Prepared prepared) {
    if (own.isEmpty()) {
      return;
    }
    if (phase == Phase.LEAVING) {
      goBack(text("wasGivenUp", own.get().test().id().name()));
      return;
    }
    phase = Phase.RUNNING;
    SavedProgram saved = prepared.file();
    ProgramDocument document = programs.of(saved.path()).orElseGet(() -> ProgramDocument.of(saved));
    programs.open(document);
    DebuggedTest test = prepared.test();
    SessionMember tested = session.members().getFirst();
    starts.accept(
        document,
        new RunScript(
            test.program().source(),
            document.script().text(),
            lines(test),
            0,
            0,
            GeneratedNames.NONE));
    if (test.watches()) {
      tell.accept(text("breakpointsInStopTheTestThose", test.file()));
    }
    Pace pace = own.get().pace() instanceof Pace.Paused ? Pace.REAL_TIME : own.get().pace();
    var _ =
        session
            .submit(
                tested,
                new DebugCommand.Debug(_ -> test.begin(command -> submit(tested, test, command))))
            .thenAccept(_ -> session.setPace(pace));
  }

  private static RunLines lines(DebuggedTest test) {
    return new RunLines() {
      @Override
      public int toShown(int run) {
        return test.lineInFile(run);
      }

      @Override
      public List<Integer> toRun(int shown) {
        return test.lineInFile(shown) == shown ? List.of(shown) : List.of();
      }
    };
  }

  /** A program that the debugger does not know is one of others. */
  private CompletableFuture<Reply> submit(
      SessionMember tested, DebuggedTest test, Command command) {
    return command instanceof ProgramCommand.StartProgram start
            && start.program().equals(test.program())
        ? session.start(tested, start)
        : session.submit(tested, command);
  }

  private void frame(DebuggedTest test, ControllerState state) {
    test.after(state).ifPresent(result -> EventQueue.invokeLater(() -> over(result)));
  }

  private void over(TestResult result) {
    if (own.isEmpty() || phase != Phase.RUNNING) {
      return;
    }
    ended.accept(result);
    goBack(
        result.failure().isPresent()
            ? text("isRed", result.id().name(), result.failure().get().message())
            : text("passed", result.id().name()));
  }

  /** Gives the test up. */
  void stop() {
    if (own.isPresent() && phase == Phase.RUNNING) {
      goBack(text("wasGivenUp", own.get().test().id().name()));
    }
    phase = Phase.LEAVING;
  }

  private void goBack(String why) {
    Own back = own.orElseThrow();
    phase = Phase.LEAVING;
    Background.run(
        () -> {
          switching = true;
          try {
            restart(back);
          } finally {
            switching = false;
          }
          return back;
        },
        _ -> left(why),
        failed -> left(failed.getMessage()));
  }

  private void restart(Own back) {
    if (back.cell().isPresent()) {
      session.restart(back.cell().get());
      session.show(back.shown());
    } else {
      session.restart(back.options());
    }
    List<SessionMember> members = session.members();
    for (int i = 0; i < members.size(); i++) {
      var _ =
          session.submit(
              members.get(i), new BoxCommand.SetSpeedFraction(back.speedFractions().get(i)));
    }
  }

  private void left(String why) {
    own = Optional.empty();
    tell.accept(why);
  }

  @Override
  public void switchingOff() {}

  /** People have switched to another robot: that is the one that stays. */
  @Override
  public void switchedOn() {
    if (!switching) {
      EventQueue.invokeLater(() -> own = Optional.empty());
    }
  }
}
