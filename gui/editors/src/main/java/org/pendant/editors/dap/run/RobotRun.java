package org.pendant.editors.dap.run;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.Semaphore;
import org.pendant.controller.Clock;
import org.pendant.controller.Controller;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.Drive;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.Robot;
import org.pendant.controller.VirtualClock;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.command.Reply;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.io.InputWaveforms;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.state.ControllerState;
import org.pendant.recording.Recording;
import org.pendant.recording.RecordingRing;
import org.pendant.script.debug.DebugState;
import org.pendant.script.debug.Debugger;
import org.pendant.script.value.ScriptError;
import org.pendant.script.vm.Program;

/**
 * Robot run: one program on one controller, driven by a thread of its own, as {@code pendant run}
 * does. Before the program begins, while a debugger holds it, at a safety stop and after the end no
 * time passes and nothing is computed; requests are answered all the same. Any thread may call it.
 */
public final class RobotRun implements AutoCloseable {
  /** Memory of the recording: some minutes of an arm that never rests. */
  private static final long RECORDING_BYTES = 64L << 20;

  private static final double NS = 1e-9;

  private final Robot robot;
  private final Drive drive;
  private final InputWaveforms waveforms;
  private final Runnable outside;
  private final RunListener listener;
  private final Executor answers;
  private final ProgramFollower follower;
  private final RecordingRing ring;
  private final Semaphore work = new Semaphore(0);
  private final Thread thread;
  private Clock clock;
  private long toldLostNs;
  private long lastStop;
  private volatile boolean starting;
  private volatile boolean passing;
  private volatile boolean stopAtSafetyStops;
  private volatile boolean closing;
  private volatile boolean over;
  private volatile boolean holdAfterFrame;
  private volatile boolean atSafetyStop;
  private volatile Optional<FrameWatch> watch = Optional.empty();

  /** Asks the debugger something before each frame; it may hold the program. */
  @FunctionalInterface
  public interface FrameWatch {
    void look(Debugger debugger);
  }

  /** Something to ask the debugger. */
  @FunctionalInterface
  public interface Question<T> {
    /**
     * Asks it.
     *
     * @throws IllegalArgumentException if it cannot be done now
     * @throws ScriptError if an expression fails
     */
    T of(Debugger debugger) throws ScriptError;
  }

  private RobotRun(
      Controller controller, DebugTarget target, RunListener listener, Executor answers) {
    robot = controller;
    this.answers = answers;
    drive = controller;
    clock = target.clock().get();
    waveforms = target.waveforms();
    outside = target.outside();
    this.listener = listener;
    follower = new ProgramFollower(controller, listener);
    ring = new RecordingRing(controller.state(), controller::programSource, RECORDING_BYTES);
    thread = Thread.ofPlatform().daemon().name("debugged robot").unstarted(this::drive);
  }

  /**
   * Begins to drive a controller; no program runs yet.
   *
   * @param answers takes what comes of questions
   */
  public static RobotRun begin(
      Controller controller, DebugTarget target, RunListener listener, Executor answers) {
    RobotRun run = new RobotRun(controller, target, listener, answers);
    run.drive.wakeBy(run.work::release);
    run.thread.start();
    return run;
  }

  /** The robot, to be read and asked. */
  public Robot robot() {
    return robot;
  }

  /** What it has done so far. */
  public Recording recording() {
    return ring.recording();
  }

  /** Whether people want to look at a safety stop before it ends the program. */
  public void stopAtSafetyStops(boolean wanted) {
    stopAtSafetyStops = wanted;
  }

  /** Has {@code watch} asked before each frame from now on; empty for nothing. */
  public void watch(Optional<FrameWatch> watch) {
    this.watch = watch;
  }

  /**
   * Starts the program; why it cannot, if it cannot.
   *
   * @param file of it, in whose folder it may read
   * @param held whether it is held before its first statement
   */
  public CompletableFuture<Optional<String>> start(Program program, String file, boolean held) {
    // the commands stay together until time passes, so that each run is the same
    starting = true;
    if (!waveforms.equals(InputWaveforms.NONE)) {
      var _ = robot.submit(new IoCommand.PlayInputs(waveforms));
    }
    CompletableFuture<Reply> started =
        robot.submit(
            new ProgramCommand.StartProgram(program, Optional.of(ProgramsFolder.of(file))));
    if (held) {
      var _ = robot.submit(new DebugCommand.Debug(Debugger::pause));
    }
    // told before what the program does
    CompletableFuture<Optional<String>> told = started.thenApplyAsync(Reply::complaint, answers);
    letPass();
    return told;
  }

  private void letPass() {
    passing = true;
    starting = false;
    work.release();
  }

  /** Whether a safety stop is to be looked at, and time stands still for that. */
  public boolean atSafetyStop() {
    return atSafetyStop;
  }

  /** Goes on after a safety stop: nobody is here to end it, so the program ends. */
  public void leaveSafetyStop() {
    atSafetyStop = false;
    follower.end();
    letPass();
  }

  /** Ends the program. */
  public void stop() {
    var _ = robot.submit(new ProgramCommand.StopProgram());
    if (atSafetyStop) {
      atSafetyStop = false;
      letPass();
    }
  }

  /** Has the program held again after the frame that is under way or comes next. */
  public void holdAfterFrame() {
    holdAfterFrame = true;
  }

  /** Whether nothing of the program is left. */
  public boolean over() {
    return over;
  }

  /**
   * Asks the debugger; fails with {@link IllegalArgumentException} or {@link ScriptError}. The
   * answer comes by the executor that this run was given.
   */
  public <T> CompletableFuture<T> ask(Question<T> question) {
    CompletableFuture<T> found = new CompletableFuture<>();
    // before it is asked: what comes of it is told later than the answer
    CompletableFuture<T> answer = found.whenCompleteAsync((value, fault) -> {}, answers);
    var _ =
        robot
            .submit(
                new DebugCommand.Debug(
                    debugger -> {
                      try {
                        found.complete(question.of(debugger));
                      } catch (ScriptError | RuntimeException e) {
                        found.completeExceptionally(e);
                      }
                    }))
            .thenAccept(
                reply ->
                    // where it was not even asked
                    found.completeExceptionally(
                        new IllegalArgumentException(reply.complaint().orElse("nothing came"))));
    return answer;
  }

  private void drive() {
    try {
      while (!closing) {
        step();
      }
    } catch (InterruptedException e) {
      // close() asked for it
      Thread.currentThread().interrupt();
    } catch (RuntimeException | Error e) {
      listener.failed(e);
    }
  }

  private void step() throws InterruptedException {
    boolean held = drive.state().debug().held();
    if (passing && !held) {
      if (watch.isPresent()) {
        var _ = robot.submit(new DebugCommand.Debug(watch.get()::look));
      }
      var _ = clock.awaitDue(drive::waitsForOutside);
      tellLost();
      drive.advance();
    } else {
      work.acquire();
      work.drainPermits();
      clock.startAfresh();
      if (held) {
        drive.advance();
      } else if (passing || starting) {
        return;
      } else {
        drive.applyCommands();
      }
    }
    ControllerState state = drive.state();
    holdAgain(state);
    ring.take(state);
    listener.frame(state);
    if (passing && !state.debug().held()) {
      follow(state);
    }
  }

  private void holdAgain(ControllerState state) {
    long stop = state.debug().stop().map(DebugState.Stop::number).orElse(0L);
    if (holdAfterFrame && stop == 0) {
      holdAfterFrame = false;
      var _ = robot.submit(new DebugCommand.Debug(Debugger::pause));
    } else if (stop != lastStop) {
      // something else has held it within the frame
      holdAfterFrame = false;
    }
    lastStop = stop == 0 ? lastStop : stop;
  }

  private void follow(ControllerState state) {
    switch (follower.see(state, stopAtSafetyStops)) {
      case FRAMES -> {
        if (!follower.running(state) && over(state)) {
          // no user wants to wait until the arm rests
          clock = new VirtualClock();
        }
      }
      case STAND_STILL -> {
        passing = false;
        atSafetyStop = true;
        listener.safetyStop(state);
      }
      case OVER -> {
        passing = false;
        over = true;
        listener.over(follower.result(state));
      }
    }
  }

  private static boolean over(ControllerState state) {
    return state.program().ending().isPresent();
  }

  /** As a command, so that a run that is repeated hears of it at the same place. */
  private void tellLost() {
    if (clock.lostNs() != toldLostNs) {
      toldLostNs = clock.lostNs();
      var _ = robot.submit(new BoxCommand.NoteLostTime(NS * toldLostNs));
    }
  }

  /** Ends it, whatever it is doing, and waits for the running frame. */
  @Override
  public void close() {
    closing = true;
    thread.interrupt();
    boolean interrupted = false;
    while (thread.isAlive()) {
      try {
        thread.join();
      } catch (InterruptedException e) {
        interrupted = true;
      }
    }
    // may wait for the last bytes of a program, which nobody has to wait for here
    Thread.ofVirtual().name("debugged robot's connections").start(outside);
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }
}
