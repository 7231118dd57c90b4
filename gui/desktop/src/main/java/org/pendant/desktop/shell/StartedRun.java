package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.debug.DebugPresenter;
import org.pendant.desktop.program.RunNode;
import org.pendant.desktop.program.TreeRuns;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.ProgramPhase;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.session.RunTime;
import org.pendant.desktop.shell.run.RunProgram;
import org.pendant.language.source.ByteText;
import org.pendant.script.vm.ProgramState;

/** Started run: the program that was started last, for the Run screen. */
final class StartedRun implements RunProgram {
  /** Least time between two looks at the turns, ms. */
  private static final long PERIOD_MS = 200;

  private final RobotSession session;
  private final Programs programs;
  private final ProgramRunner runner;
  private final DebugPresenter debug;
  private final TreeRuns runs;
  private final ActiveInstallation installation;
  private final IntConsumer showLine;
  private final Consumer<RunNode> showNode;
  private long lookedMs;
  private boolean ran;
  private ProgramDocument front;

  /** The run from whose program people have turned to another one. */
  private RunTime left = RunTime.NONE;

  /**
   * The program that {@code runner} started last.
   *
   * @param showLine shows a line of what runs
   */
  StartedRun(
      RobotSession session,
      Programs programs,
      ProgramRunner runner,
      DebugPresenter debug,
      TreeRuns runs,
      ActiveInstallation installation,
      IntConsumer showLine,
      Consumer<RunNode> showNode) {
    this.session = session;
    this.programs = programs;
    front = programs.current();
    programs.addListener(this::follow);
    this.runner = runner;
    this.debug = debug;
    this.runs = runs;
    this.installation = installation;
    this.showLine = showLine;
    this.showNode = showNode;
  }

  /** Another program may be in front. */
  private void follow() {
    if (front != programs.current()) {
      front = programs.current();
      if (ProgramPhase.of(session.state()) == ProgramPhase.STOPPED) {
        left = session.runTime();
      }
    }
  }

  @Override
  public Optional<String> next() {
    return Optional.of(programs.current().name());
  }

  /** A program of others goes by the name that it gives itself. */
  @Override
  public String name(ControllerState state) {
    String own = ByteText.decoded(state.program().name());
    return session.strangerLast() && !own.isEmpty()
        ? text("sentFromOutside", own)
        : runner.program().map(ProgramDocument::name).orElse(own);
  }

  @Override
  public boolean left(ControllerState state) {
    return ProgramPhase.of(state) == ProgramPhase.STOPPED
        && left.equals(time())
        && !runner.program().equals(Optional.of(programs.current()));
  }

  @Override
  public Optional<List<LogEntry>> recordedLog() {
    return Optional.empty();
  }

  @Override
  public Optional<RunNode> nodeAt(int line) {
    return runs.node(runner.program(), debug.lineNow(line));
  }

  @Override
  public RunTime time() {
    return session.runTime();
  }

  @Override
  public String lineText(int line) {
    return session.strangerLast()
        ? session
            .startedSource()
            .filter(source -> line >= 1 && line <= source.lineCount())
            .map(source -> source.lineText(line))
            .orElse("")
        : runner.line(line);
  }

  @Override
  public int shownLine(int line) {
    return debug.lineNow(line);
  }

  @Override
  public void showLine(int line) {
    showLine.accept(line);
  }

  @Override
  public Optional<RunNode> node(ControllerState state) {
    return runs.now(runner.program(), state);
  }

  @Override
  public void show(RunNode node) {
    showNode.accept(node);
  }

  @Override
  public OptionalLong turns(ControllerState state) {
    boolean runsNow = state.program().state() != ProgramState.STOPPED;
    long nowMs = System.nanoTime() / 1_000_000;
    // Once more when it has ended.
    if ((runsNow || ran) && nowMs - lookedMs >= PERIOD_MS) {
      ran = runsNow;
      lookedMs = nowMs;
      debug.breakpoints().lookAtTurns();
    }
    return runner.program().isPresent() ? debug.breakpoints().turns() : OptionalLong.empty();
  }

  @Override
  public List<InstallationVariable> installationVariables() {
    return installation.current().variables();
  }
}
