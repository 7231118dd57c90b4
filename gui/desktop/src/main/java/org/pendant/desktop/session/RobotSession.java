package org.pendant.desktop.session;

import static org.pendant.desktop.session.SessionTexts.text;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.ReentrantLock;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import org.pendant.controller.Cell;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.Pace;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.Robot;
import org.pendant.controller.WallClock.Lateness;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.safety.SafetyChecksum;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.session.ArmReadiness.Light;
import org.pendant.kit.fault.Faults;
import org.pendant.language.source.Source;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.json.JsonException;
import org.pendant.protocols.toolserial.ToolSerialLine;
import org.pendant.recording.NumberStore;
import org.pendant.recording.Recording;
import org.pendant.recording.lines.LineProfiler;
import org.pendant.recording.lines.RunProfile;
import org.pendant.recording.replay.Journal;
import org.pendant.recording.replay.ParkedRuns;
import org.pendant.recording.replay.Rerun;
import org.pendant.recording.replay.RerunRefused;
import org.pendant.recording.whatif.Variant;
import org.pendant.recording.whatif.VariantLimits;
import org.pendant.recording.whatif.VariantRun;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.Program;

/**
 * Robot session: the controller that the desktop works with, and the thread that drives it at the
 * chosen pace. Any thread may call it; no call waits for a frame except {@link #restart} and {@link
 * #close}. Programs can be run once more up to any frame, and continue otherwise from there: {@link
 * #branch}.
 *
 * <p>What is chained to a reply runs in the frame loop unless an executor is named: views chain
 * with {@code SwingUtilities::invokeLater}.
 */
public final class RobotSession implements AutoCloseable {
  private final List<FrameListener> listeners = new CopyOnWriteArrayList<>();
  private final List<SwitchListener> switchListeners = new CopyOnWriteArrayList<>();
  private final List<CellListener> cellListeners = new CopyOnWriteArrayList<>();
  private final AtomicReference<String> trouble = new AtomicReference<>();
  private final NumberStore store = new NumberStore(this::staysInMemory);
  private final ReentrantLock switching = new ReentrantLock();
  private volatile DrivenControllers driven;

  /** How the controllers of a cell were switched on; empty for one that is alone. */
  private volatile Optional<CellSetup> cell = Optional.empty();

  /** How the one that is alone is, or was before there was a cell. */
  private volatile ControllerOptions alone;

  /** Whether others have made the controllers that there are: those of people come back. */
  private volatile boolean lent;

  private volatile Optional<Branching> branching = Optional.empty();
  private boolean closed;

  private RobotSession(ControllerOptions options) {
    alone = options;
    SessionMember only = SessionMember.alone(SwitchedOn.with(options, store));
    driven = drive(List.of(only), 0, Pace.REAL_TIME);
  }

  private DrivenControllers drive(List<SessionMember> members, int shown, Pace pace) {
    return new DrivenControllers(members, shown, pace, listeners, cellListeners);
  }

  /**
   * Switches a controller on, in real time.
   *
   * @throws IllegalArgumentException if the robot or an input is not known
   */
  public static RobotSession start(ControllerOptions options) {
    return new RobotSession(options);
  }

  /** The controllers: one that is alone, or those of a cell in their order. */
  public List<SessionMember> members() {
    return driven.members();
  }

  /** The one that people look at: all that is asked here is asked of it. */
  public SessionMember shown() {
    return driven.shown();
  }

  /** How the controllers of a cell were switched on; empty for one that is alone. */
  public Optional<CellSetup> cell() {
    return cell;
  }

  /** Whether several controllers share a cell. */
  public boolean inCell() {
    return cell.isPresent();
  }

  /**
   * Shows another controller of the cell; all of them continue.
   *
   * @throws IllegalArgumentException if there is none of that name
   */
  public void show(String name) {
    switching.lock();
    try {
      List<String> names = members().stream().map(SessionMember::name).toList();
      int number = names.indexOf(name);
      if (number < 0) {
        throw new IllegalArgumentException(
            "controller is " + name + ", must be one of " + String.join(", ", names));
      }
      if (!shown().name().equals(name)) {
        driven.between(
            () -> {
              switchListeners.forEach(each -> Faults.guard(each::leaving));
              driven.show(number);
            });
        switchListeners.forEach(each -> Faults.guard(each::shown));
      }
    } finally {
      switching.unlock();
    }
  }

  /** Runs something between two frames: what it leaves for controllers comes in the same one. */
  public void between(Runnable work) {
    driven.between(work);
  }

  /** How the controller was switched on. */
  public ControllerOptions options() {
    return shown().options();
  }

  /** The robot; another one after {@link #restart}, so nobody should keep it. */
  public Robot robot() {
    return shown().robot();
  }

  /**
   * The newest snapshot. After {@link #restart} frames, log lines and popups count from 0 again.
   */
  public ControllerState state() {
    return shown().state();
  }

  /**
   * What the controller did in the last minutes; it stays as it is while the controller continues,
   * so ask again for what is newer. Costs next to nothing. After {@link #restart} there is another
   * one, which begins with the new controller; that of a branch has the run up to its frame.
   */
  public Recording recording() {
    return shown().recording();
  }

  /** That the recording stays in memory because its file cannot be written; told once. */
  public Optional<String> newTrouble() {
    return Optional.ofNullable(trouble.getAndSet(null));
  }

  private void staysInMemory(IOException e) {
    trouble.set(text("theRecordingStaysInMemoryIts", e.getMessage()));
  }

  /** How much of recordings is in a file rather than in memory, also of what nobody needs. */
  public long storedBytes() {
    return store.usedBytes();
  }

  /** Leaves a command for the next frame; while robot time is paused it is carried out at once. */
  public CompletableFuture<Reply> submit(Command command) {
    return driven.submit(shown(), command);
  }

  /** Parses, checks and compiles a program; slow, so not for the dispatch thread. */
  public LoadResult load(Source source) {
    return robot().load(source);
  }

  /**
   * Starts a program from its beginning; a secondary one runs to its end beside the present one.
   */
  public CompletableFuture<Reply> run(Program program) {
    return run(shown(), program);
  }

  /** As {@link #run(Program)}, on one of the controllers. */
  public CompletableFuture<Reply> run(SessionMember member, Program program) {
    Optional<ProgramsFolder> folder = Optional.of(ProgramsFolder.of(program.source().name()));
    return program.secondary()
        ? driven.submit(member, new ProgramCommand.RunSecondary(program, folder))
        : member
            .runs()
            .origin()
            .expect(() -> driven.submit(member, new ProgramCommand.StartProgram(program, folder)));
  }

  /** Leaves a command for one of the controllers. */
  public CompletableFuture<Reply> submit(SessionMember member, Command command) {
    return driven.submit(member, command);
  }

  /** The commands that came into force after the end of a frame, as far as they are kept. */
  public List<Journal.Noted> commandsAfter(long frame) {
    return shown().journal().after(frame);
  }

  /** How many programs have started that {@link #run} did not start: others have sent them. */
  public long strangersStarted() {
    return shown().runs().origin().strangers();
  }

  /** The text of the program that was started last; empty if it is not known any more. */
  public Optional<Source> startedSource() {
    return shown().startedSource();
  }

  /** The text of the program that runs, or ran last; only for what is asked in the frame loop. */
  Optional<Source> programSource() {
    return shown().on().controller().programSource();
  }

  /** Whether the program that runs, or ran last, came from others. */
  public boolean strangerLast() {
    return shown().runs().origin().strangerLast();
  }

  /** How long the program that was started last has run. */
  public RunTime runTime() {
    return shown().runs().runClock().time();
  }

  /** What the lines of the program that was started last have taken so far. */
  public RunProfile profile() {
    return shown().runs().profiler().profile();
  }

  /** The safety limits and planes that hold. */
  public SafetyConfiguration safety() {
    return robot().safety();
  }

  /**
   * The safety limits and planes that held in a recording, if they are those that hold now;
   * otherwise what is standard for its arm, as no recording has them.
   *
   * @param checksum of those that held
   */
  public SafetyConfiguration safety(SafetyChecksum checksum, ArmDescription arm) {
    SafetyConfiguration now = safety();
    return SafetyChecksum.of(now).equals(checksum) ? now : SafetyConfiguration.standard(arm);
  }

  /** Pauses the program. */
  public CompletableFuture<Reply> pause() {
    return submit(new ProgramCommand.PauseProgram());
  }

  /** Resumes a paused program. */
  public CompletableFuture<Reply> resume() {
    return submit(new ProgramCommand.ResumeProgram());
  }

  /** Ends the program. */
  public CompletableFuture<Reply> stop() {
    return submit(new ProgramCommand.StopProgram());
  }

  /** How robot time goes by. */
  public Pace pace() {
    return driven.clock().pace();
  }

  /** Changes how robot time goes by. */
  public void setPace(Pace pace) {
    driven.clock().setPace(pace);
  }

  /** Lets one frame of 2 ms pass while robot time is paused; otherwise nothing happens. */
  public void stepFrame() {
    driven.clock().grant(1);
  }

  /** Whether a debugger has paused a program of any controller: robot time stands still. */
  public boolean held() {
    return members().stream().anyMatch(each -> each.state().debug().held());
  }

  /** How punctual the frames are, since the controller was switched on. */
  public Lateness lateness() {
    return driven.clock().lateness();
  }

  /** Has {@code listener} see every frame, also those of controllers to come. */
  public void addFrameListener(FrameListener listener) {
    listeners.add(listener);
  }

  /** Ends {@link #addFrameListener}. */
  public void removeFrameListener(FrameListener listener) {
    listeners.remove(listener);
  }

  /** Has {@code listener} see every frame of each controller, also of those to come. */
  public void addCellListener(CellListener listener) {
    cellListeners.add(listener);
  }

  /** Has {@code listener} told when the controller is switched off and another one on. */
  public void addSwitchListener(SwitchListener listener) {
    switchListeners.add(listener);
  }

  /** The serial line of the tool connector; another one after {@link #restart}. */
  public ToolSerialLine toolSerial() {
    return shown().toolSerial();
  }

  /** What ended the frame loop although nobody asked for it: a fault of ours. */
  public Optional<Throwable> failure() {
    return driven.loop().failure();
  }

  /**
   * Switches the controller off and another one on, such as for a different robot. Programs end;
   * the speed of programs stays. Waits for the running frame, so not for the dispatch thread.
   *
   * @throws IllegalArgumentException if the robot or an input is not known; nothing has changed
   */
  public void restart(ControllerOptions options) {
    // Made first: where that fails, the old one continues.
    SwitchedOn next = SwitchedOn.with(options, store);
    cancelBranch();
    double speedFraction = state().arm().speedFraction();
    switching.lock();
    try {
      exchange(next, pace(), false);
      alone = options;
      var _ = submit(new BoxCommand.SetSpeedFraction(speedFraction));
    } finally {
      switching.unlock();
    }
  }

  /**
   * Switches the controllers off and those of a cell on, of which the first is shown. Not for the
   * dispatch thread.
   *
   * @throws IllegalArgumentException if the cell cannot be as its file says; nothing has changed
   */
  public void restart(CellSetup setup) {
    List<SessionMember> next;
    try {
      next = SwitchedOn.with(setup, store);
    } catch (JsonException e) {
      throw new IllegalArgumentException(e.getMessage(), e);
    }
    cancelBranch();
    switching.lock();
    try {
      List<String> names = next.stream().map(SessionMember::name).toList();
      int before = Math.max(0, names.indexOf(shown().name()));
      exchange(Optional.of(setup), false, () -> drive(next, before, pace()));
    } finally {
      switching.unlock();
    }
  }

  /**
   * Switches what there is off and on, each controller with other options.
   *
   * @throws IllegalArgumentException as {@link #restart(ControllerOptions)}
   */
  public void restartWith(UnaryOperator<ControllerOptions> change) {
    Optional<CellSetup> shared = cell;
    if (shared.isPresent()) {
      restart(shared.get().with(change));
    } else {
      restart(change.apply(options()));
    }
  }

  /**
   * As {@link #restartWith}, where people ask for something else than a restart: each arm has power
   * afterwards if it has it now, see {@link #keepingPower}.
   */
  public void changeWith(UnaryOperator<ControllerOptions> change) {
    Optional<CellSetup> shared = cell;
    if (shared.isPresent()) {
      restart(shared.get().with(change).with(this::keepingPower));
    } else {
      restart(keepingPower(shown().name(), change.apply(options())));
    }
  }

  /**
   * Options of a controller in the place of the one of that name. Its arm has power if this one is
   * ready for programs, so that an arm that is off, or that something has stopped, does not come on
   * by itself. As they are where there is none of that name.
   */
  public ControllerOptions keepingPower(String name, ControllerOptions options) {
    return members().stream()
        .filter(each -> each.name().equals(name) && !each.armless())
        .findFirst()
        .map(each -> options.withPower(ArmReadiness.of(each.state()).light() == Light.READY))
        .orElse(options);
  }

  /** How the controller that is alone is switched on, or was before there was a cell. */
  public ControllerOptions aloneOptions() {
    return inCell() ? alone : options();
  }

  /**
   * Has a controller that others have made take the place of the present one, as {@link #restart}
   * does, with robot time paused. It stays until {@link #restart}. Not for the dispatch thread.
   *
   * @param options that it was made with
   * @param made has run no frame, and is driven by nobody
   * @param guest sees its frames before all others
   */
  public void lend(ControllerOptions options, Controller made, FrameListener guest) {
    SwitchedOn next = SwitchedOn.of(options, made, guest, store);
    cancelBranch();
    switching.lock();
    try {
      exchange(next, new Pace.Paused(), true);
    } finally {
      switching.unlock();
    }
  }

  /**
   * As {@link #lend(ControllerOptions, Controller, FrameListener)}, with those of a cell, of which
   * the first is shown.
   *
   * @param setup that the cell was made with
   * @param guest sees the frames of the first controller before all others
   */
  public void lend(CellSetup setup, Cell made, FrameListener guest) {
    List<SessionMember> next = SwitchedOn.of(setup, made, guest, store);
    cancelBranch();
    switching.lock();
    try {
      exchange(Optional.of(setup), true, () -> drive(next, 0, new Pace.Paused()));
    } finally {
      switching.unlock();
    }
  }

  /** Whether others have made the controllers that there are, for a while. */
  public boolean lent() {
    return lent;
  }

  /** Starts a program for the user: it is none of those that others send. */
  public CompletableFuture<Reply> start(SessionMember member, ProgramCommand.StartProgram command) {
    return member.runs().origin().expect(() -> driven.submit(member, command));
  }

  private void exchange(SwitchedOn next, Pace pace, boolean forOthers) {
    SessionMember before = shown();
    boolean wasAlone = !inCell();
    exchange(
        Optional.empty(),
        forOthers,
        () ->
            drive(
                List.of(wasAlone ? before.replacedBy(next) : SessionMember.alone(next)), 0, pace));
  }

  private void exchange(
      Optional<CellSetup> setup, boolean forOthers, Supplier<DrivenControllers> next) {
    switchListeners.forEach(each -> Faults.guard(each::switchingOff));
    driven.close();
    cell = setup;
    lent = forOthers;
    driven = next.get();
    switchListeners.forEach(each -> Faults.guard(each::switchedOn));
  }

  /** Why there can be no branch from the end of a frame; empty if there can. */
  public Optional<String> branchRefusal(long frame) {
    return shown().journal().run().refusal(frame);
  }

  /**
   * People look at a frame: a {@link #branch} from about there shall not take long. At next to no
   * cost.
   *
   * @param frame empty for now
   */
  public void look(OptionalLong frame) {
    shown().on().parked().look(frame);
  }

  /**
   * Begins to branch from the end of a frame of the present run: other controllers with the same
   * options run up to it, with the same commands in the same frames and as fast as the processor
   * goes, and take the places of the present ones as after {@link #restart}. Robot time is paused
   * then, so that people can look and change something before it continues. Until that moment the
   * present controllers continue; a branch that was begun before is cancelled.
   *
   * @param frame 0 to that of the newest snapshot
   * @throws RerunRefused if the run cannot be repeated so far; nothing has changed
   */
  public Branching branch(long frame) throws RerunRefused {
    DrivenControllers from = driven;
    return branch(from, Rerun.to(frame, from.shown().journal().run()));
  }

  /**
   * As {@link #branch(long)}; refused in the end if the new controllers do not stand as the old
   * ones did.
   *
   * @param recorded a snapshot of the present run, of the controller that is shown
   */
  public Branching branch(ControllerState recorded) throws RerunRefused {
    DrivenControllers from = driven;
    return branch(
        from,
        Rerun.to(recorded.frame(), from.shown().journal().run(), from.recordedBeside(recorded)));
  }

  private Branching branch(DrivenControllers from, Rerun rerun) {
    cancelBranch();
    Branching begun = Branching.begin(rerun, () -> branchOff(from, rerun));
    branching = Optional.of(begun);
    return begun;
  }

  private void branchOff(DrivenControllers from, Rerun rerun) throws RerunRefused {
    List<SwitchedOn> next = SwitchedOn.again(from.on(), rerun, store);
    List<LineProfiler> lines = from.linesUntil(next);
    switching.lock();
    try {
      if (closed || driven != from) {
        next.forEach(SwitchedOn::close);
        throw new RerunRefused(text("theControllerWasSwitchedOffMeanwhile"));
      }
      exchange(cell, lent, () -> driveBranch(from, next, lines));
    } finally {
      switching.unlock();
    }
  }

  private DrivenControllers driveBranch(
      DrivenControllers from, List<SwitchedOn> next, List<LineProfiler> lines) {
    DrivenControllers made =
        drive(from.repeatedBy(next, lines), from.shownNumber(), new Pace.Paused());
    // clients that had taken signals are gone with the ports
    made.releaseSignals();
    return made;
  }

  /**
   * Prepares a run of a variant of the present run of a controller; nothing has run yet. Not for
   * the dispatch thread.
   *
   * @param of one of {@link #members}
   * @param frame at whose end it begins; empty for the start of the program that was started last
   * @throws RerunRefused if the run cannot be repeated so far, or no program was started
   */
  public VariantRun variant(
      SessionMember of, OptionalLong frame, Variant variant, VariantLimits limits)
      throws RerunRefused {
    ParkedRuns parked = of.on().parked();
    int member = of.journal().member();
    parked.follow();
    return frame.isPresent()
        ? VariantRun.from(frame.getAsLong(), parked, member, variant, limits)
        : VariantRun.fromStart(parked, member, variant, limits);
  }

  /** Whether a program has been started that is still known. */
  public boolean programKnown() {
    return startedSource().isPresent();
  }

  private void cancelBranch() {
    branching.ifPresent(Branching::cancel);
  }

  /** Switches the controller off. */
  @Override
  public void close() {
    cancelBranch();
    switching.lock();
    try {
      closed = true;
      switchListeners.forEach(each -> Faults.guard(each::switchingOff));
      driven.close();
    } finally {
      switching.unlock();
    }
  }
}
