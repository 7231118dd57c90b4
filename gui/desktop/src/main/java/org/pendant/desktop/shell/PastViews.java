package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.awt.EventQueue;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.Set;
import java.util.function.Function;
import java.util.function.IntFunction;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.safety.SafetyChecksum;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.editor.Execution;
import org.pendant.desktop.editor.ScriptEditor;
import org.pendant.desktop.lines.MotionView;
import org.pendant.desktop.log.LogPlace;
import org.pendant.desktop.log.LogPlaces;
import org.pendant.desktop.log.LogView;
import org.pendant.desktop.program.RunNode;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.session.RunTime;
import org.pendant.desktop.session.SwitchListener;
import org.pendant.desktop.shell.run.RunProgram;
import org.pendant.desktop.timeline.EarlierRun;
import org.pendant.desktop.timeline.ExplainedMoment;
import org.pendant.desktop.timeline.HeldView;
import org.pendant.desktop.timeline.LookBack;
import org.pendant.desktop.timeline.PastActions;
import org.pendant.desktop.timeline.PastBanner;
import org.pendant.desktop.timeline.PastRunTime;
import org.pendant.desktop.timeline.PastSteps;
import org.pendant.desktop.timeline.RecordedText;
import org.pendant.desktop.timeline.TimelineView;
import org.pendant.desktop.workbench.View;
import org.pendant.kit.action.Action;
import org.pendant.language.source.ByteText;
import org.pendant.recording.Moment;
import org.pendant.recording.RecordedProgram;
import org.pendant.recording.Recording;
import org.pendant.recording.explain.MotionExplanation;
import org.pendant.script.debug.Breakpoint;
import org.pendant.script.vm.ProgramState;

/** Views of the past: what the window does while people look at the past. */
final class PastViews {
  /** The views that show the moment that people look at; the others stay with now. */
  private static final Set<String> FOLLOWERS = Set.of("run", "move", "io", "scene", "variables");

  /** So long before a stop the way to it can be seen, s. */
  private static final double BEFORE_STOP_S = 2;

  private final ShellWorkbench workbench;
  private final Programs programs;
  private final ScriptEditor editor;
  private final LookBack lookBack;
  private final PastRunTime runTime;
  private final ExplainedMoment explained;
  private final PastBanner banner;
  private final TimelineView timeline;
  private final PastSteps steps;
  private Optional<ProgramDocument> marked = Optional.empty();
  private Optional<Moment> searched = Optional.empty();
  private Optional<List<LogEntry>> shownLog = Optional.empty();
  private IntFunction<String> place = line -> text("line", line);
  private LogPlaces logPlaces = (timeS, source, line) -> Optional.empty();

  /**
   * Shows now.
   *
   * @param breakpoints the breakpoints of an open program that stop it
   */
  PastViews(
      ShellWorkbench workbench,
      Programs programs,
      ScriptEditor editor,
      Function<ProgramDocument, List<Breakpoint>> breakpoints) {
    this.workbench = workbench;
    this.programs = programs;
    this.editor = editor;
    lookBack = new LookBack(workbench.session()::recording, workbench::notify);
    runTime = new PastRunTime(lookBack);
    explained = new ExplainedMoment(lookBack, this::explain, workbench::notify);
    banner = new PastBanner(lookBack, new RecordedText());
    timeline = new TimelineView(workbench, lookBack, this::chooseFile);
    steps =
        PastSteps.of(
            lookBack,
            workbench.session()::state,
            workbench.session()::held,
            ran -> open(ran).map(breakpoints).orElse(List.of()),
            workbench::notify);
    PastActions.addTo(workbench.actions(), steps);
    workbench
        .actions()
        .add(
            Action.of(
                TimelineView.ID + ".compare",
                text("timelineCompareTheLastRunWith"),
                "",
                this::chooseEarlier));
    workbench.session().addSwitchListener(new Switched());
  }

  /** Another controller has another past. */
  private final class Switched implements SwitchListener {
    @Override
    public void switchingOff() {}

    @Override
    public void switchedOn() {
      EventQueue.invokeLater(
          () -> {
            runTime.forget();
            if (!lookBack.ofFile()) {
              lookBack.live();
            }
          });
    }

    @Override
    public void shown() {
      switchedOn();
    }
  }

  /** The panel with the timeline. */
  TimelineView timeline() {
    return timeline;
  }

  /** How people go back and on through what a program did. */
  PastSteps steps() {
    return steps;
  }

  /** The moment that people look at, explained; empty for now. */
  Optional<MotionExplanation> explanation() {
    return explained.explanation();
  }

  private MotionExplanation explain(Recording recording, long frame, boolean ofFile) {
    RobotSession session = workbench.session();
    SafetyChecksum held = recording.atFrame(frame).safety().checksum();
    return MotionExplanation.of(
        recording,
        frame,
        session.safety(held, recording.arm()),
        !ofFile && session.options().startRamp());
  }

  /** Looks at a moment and says why the arm moved so; tells when it is not kept any more. */
  void explain(double timeS) {
    if (timeS < lookBack.recording().firstS()) {
      workbench.notify(text("thatMomentIsNotInThe"));
      return;
    }
    lookBack.jump(timeS);
    workbench.show(MotionView.ID);
  }

  /** What the timeline shows. */
  Recording recording() {
    return lookBack.recording();
  }

  /** Stands above the views. */
  PastBanner banner() {
    return banner;
  }

  /** The moment that people look at; empty for now. */
  Optional<ControllerState> past() {
    return lookBack.past();
  }

  /** Whether that is of a recording of a file. */
  boolean ofFile() {
    return lookBack.ofFile();
  }

  /** The recording of a file that people look at; empty for none. */
  Optional<Recording> opened() {
    return ofFile() ? Optional.of(recording()) : Optional.empty();
  }

  /** Whether lines are those of the program that was started last: now, or as it ran. */
  boolean ofLastRun() {
    if (!lookBack.back()) {
      return true;
    }
    Optional<RecordedProgram> last = recording().programs().stream().reduce((first, next) -> next);
    return !lookBack.ofFile() && lookBack.program().equals(last);
  }

  /** Whether the program that ran at a time is the one that was started last. */
  boolean ofLastRun(double timeS) {
    Optional<RecordedProgram> last = recording().programs().stream().reduce((first, next) -> next);
    return !lookBack.ofFile() && recording().programAt(timeS).equals(last);
  }

  /** The open program that ran at a time. */
  Optional<ProgramDocument> programAt(double timeS) {
    return recording().programAt(timeS).flatMap(this::open);
  }

  /** A view in which people act on the robot, which they cannot in the past. */
  View held(View view) {
    return new HeldView(view, lookBack, workbench::notify);
  }

  /** As {@link #held}, for a view of variables, which can be selected. */
  View selectable(View view) {
    return new HeldView(view, lookBack, workbench::notify, true);
  }

  /** What a line of the program of the moment that people look at is called. */
  void setPlaces(IntFunction<String> names) {
    place = names;
  }

  /** What lines of programs that ran are called in their logs, and how they are shown. */
  void setRunPlaces(RunPlaces places) {
    steps.nameLinesBy(
        (ran, line) ->
            open(ran)
                .flatMap(document -> places.place(document, line, line))
                .map(LogPlace::words)
                .orElseGet(() -> text("line", line)));
    logPlaces =
        (timeS, source, line) ->
            recording()
                .programAt(timeS)
                .filter(ran -> ran.source().name().equals(source))
                .flatMap(this::open)
                .flatMap(document -> places.place(document, line, line));
  }

  /** Opens a recording. */
  void open(Path file) {
    timeline.open(file, workbench::notify);
  }

  private void chooseEarlier() {
    EarlierRun earlier = new EarlierRun(workbench, lookBack, place);
    OpenDialog.show(
        timeline.component(),
        text("compareTheLastRunWith"),
        text("recordings"),
        new String[] {"rec"},
        workbench.usedFolder(),
        earlier::compareWith);
  }

  private void chooseFile() {
    OpenDialog.show(
        timeline.component(),
        text("openRecording"),
        text("recordings"),
        new String[] {"rec"},
        workbench.usedFolder(),
        this::open);
  }

  /** Shows how it came to a stop. */
  void showBefore(double timeS) {
    workbench.show(TimelineView.ID);
    lookBack.jump(timeS - BEFORE_STOP_S);
  }

  /** Shows a moment. */
  void show(double timeS) {
    workbench.show(TimelineView.ID);
    lookBack.jump(timeS);
  }

  /** What a view shall show. */
  ControllerState shown(View view, ControllerState live) {
    return FOLLOWERS.contains(view.id()) ? lookBack.shown(live) : live;
  }

  /**
   * Takes the newest snapshot and has the editor show the line of the past.
   *
   * @return whether there is a past to show, so that no other view shows a line
   */
  boolean follow(ControllerState live, LogView log) {
    lookBack.take(live);
    if (!lookBack.log().equals(shownLog)) {
      shownLog = lookBack.log();
      log.showRecorded(shownLog, logPlaces);
    }
    if (!lookBack.back()) {
      if (searched.isPresent()) {
        searched = Optional.empty();
        unmark();
        log.lookAtNow();
        banner.refresh(false);
      }
      return false;
    }
    if (searched.isEmpty()) {
      // What stands there is about now.
      unmark();
    }
    ControllerState past = lookBack.shown(live);
    boolean fresh = false;
    if (!searched.equals(lookBack.moment())) {
      searched = lookBack.moment();
      log.lookAt(past.timeS());
      fresh = true;
    }
    Optional<RecordedProgram> ran = lookBack.program();
    Optional<ProgramDocument> open = ran.flatMap(this::open);
    if (!open.equals(marked)) {
      unmark();
      marked = open;
    }
    int line = lookBack.line();
    open.ifPresent(document -> editor.setExecution(document, Execution.running(line)));
    if (fresh) {
      open.ifPresent(document -> editor.reveal(document, line));
    }
    banner.refresh(ran.isPresent() && open.isEmpty());
    return true;
  }

  /** The line of an open program at the moment that people look at; 0 for none, empty for now. */
  OptionalInt line(ProgramDocument document) {
    if (!lookBack.back()) {
      return OptionalInt.empty();
    }
    return OptionalInt.of(marked.filter(document::equals).isPresent() ? lookBack.line() : 0);
  }

  /** The open program that ran at the moment that people look at; empty for now. */
  Optional<ProgramDocument> program() {
    return lookBack.back() ? marked : Optional.empty();
  }

  private void unmark() {
    // The mark of all others comes back with the next snapshot.
    programs.all().forEach(each -> editor.setExecution(each, Execution.NONE));
    marked = Optional.empty();
  }

  /** The open program whose text is still that which ran. */
  private Optional<ProgramDocument> open(RecordedProgram ran) {
    return programs.all().stream().filter(each -> same(each, ran)).findFirst();
  }

  private static boolean same(ProgramDocument document, RecordedProgram ran) {
    String now = document.script().text();
    String then = ran.source().text();
    // Bytes of other than ASCII characters stand as characters of their own in what ran.
    return now.length() <= then.length()
        && (now.equals(then) || now.equals(ByteText.decoded(then)));
  }

  /**
   * The program that ran then, for the Run screen.
   *
   * @param nodes the node of a line of the program of the moment that people look at
   */
  RunProgram run(RunProgram live, IntFunction<Optional<RunNode>> nodes) {
    return new PastRun(live, nodes);
  }

  private final class PastRun implements RunProgram {
    private final RunProgram live;
    private final IntFunction<Optional<RunNode>> nodes;

    PastRun(RunProgram live, IntFunction<Optional<RunNode>> nodes) {
      this.live = live;
      this.nodes = nodes;
    }

    @Override
    public Optional<String> next() {
      return lookBack.back() ? Optional.empty() : live.next();
    }

    @Override
    public String name(ControllerState state) {
      if (!lookBack.back()) {
        return live.name(state);
      }
      String name = ByteText.decoded(state.program().name());
      return program()
          .map(ProgramDocument::name)
          .orElse(name.isEmpty() ? text("noProgramYet") : name);
    }

    @Override
    public boolean left(ControllerState state) {
      return !lookBack.back() && live.left(state);
    }

    @Override
    public Optional<List<LogEntry>> recordedLog() {
      return lookBack.log();
    }

    @Override
    public Optional<RunNode> nodeAt(int line) {
      return lookBack.back() ? nodes.apply(line) : live.nodeAt(line);
    }

    @Override
    public RunTime time() {
      return lookBack.back() ? runTime.time() : live.time();
    }

    @Override
    public String lineText(int line) {
      if (!lookBack.back()) {
        return live.lineText(line);
      }
      return lookBack
          .program()
          .flatMap(ran -> ran.source().text().lines().skip(Math.max(0, line - 1)).findFirst())
          .map(ByteText::decoded)
          .orElse("");
    }

    @Override
    public int shownLine(int line) {
      return lookBack.back() ? line : live.shownLine(line);
    }

    @Override
    public void showLine(int line) {
      live.showLine(line);
    }

    @Override
    public Optional<RunNode> node(ControllerState state) {
      if (!lookBack.back()) {
        return live.node(state);
      }
      return state.program().state() == ProgramState.STOPPED
          ? Optional.empty()
          : nodes.apply(lookBack.line());
    }

    @Override
    public void show(RunNode node) {
      live.show(node);
    }

    @Override
    public OptionalLong turns(ControllerState state) {
      return lookBack.back() ? OptionalLong.empty() : live.turns(state);
    }

    @Override
    public List<InstallationVariable> installationVariables() {
      return live.installationVariables();
    }
  }
}
