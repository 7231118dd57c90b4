package org.pendant.editors.dap.run;

import static org.pendant.editors.dap.run.DebuggedRunTexts.text;

import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.Semaphore;
import java.util.function.Consumer;
import org.pendant.controller.Clock;
import org.pendant.controller.Controller;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.Drive;
import org.pendant.controller.Frames;
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
import org.pendant.script.debug.Debugger;
import org.pendant.script.vm.Program;
import org.pendant.testing.TestResult;
import org.pendant.testing.run.DebuggedTest;

/**
 * Robot run: one program on one controller, driven by a thread of its own, as {@code pendant run}
 * does. Before the program begins, while a debugger holds it, at a safety stop and after the end no
 * time passes and nothing is computed; requests are answered all the same. Any thread may call it.
 */
public final class RobotRun implements DebuggedRobot {
  /** Memory of the recording: some minutes of an arm that never rests. */
  private static final long RECORDING_BYTES = 64L << 20;

  private static final double NS = 1e-9;

  private final Robot robot;
  private final Drive drive;

  /** Lets time pass: for the controller, or for the cell that it shares with others. */
  private final Frames frames;

  private final InputWaveforms waveforms;
  private final Runnable outside;
  private final Optional<DebuggedTest> test;
  private final RunListener listener;
  private final Executor answers;
  private final DebuggerLink link;
  private final HoldAfterFrame hold;
  private final ProgramFollower follower;
  private final RecordingRing ring;
  private final Semaphore work = new Semaphore(0);
  private final Thread thread;
  private Clock clock;
  private long toldLostNs;
  private volatile boolean starting;
  private volatile boolean passing;
  private volatile boolean stopAtSafetyStops;
  private volatile boolean closing;
  private volatile boolean over;
  private volatile boolean atSafetyStop;
  private volatile Optional<FrameWatch> watch = Optional.empty();

  private RobotRun(
      Controller controller, DebugTarget target, RunListener listener, Executor answers) {
    robot = controller;
    this.answers = answers;
    link = new DebuggerLink(controller, answers);
    hold = new HoldAfterFrame(controller);
    drive = controller;
    clock = target.clock().get();
    waveforms = target.waveforms();
    outside = target.outside();
    test = target.test();
    frames = test.map(DebuggedTest::frames).orElse(controller);
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
    run.frames.wakeBy(run.work::release);
    run.thread.start();
    return run;
  }

  @Override
  public Robot robot() {
    return robot;
  }

  @Override
  public Recording recording() {
    return ring.recording();
  }

  @Override
  public void stopAtSafetyStops(boolean wanted) {
    stopAtSafetyStops = wanted;
  }

  @Override
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
    var _ = robot.submit(new DebugCommand.Debug(debugger -> debugger.followCalls(true)));
    CompletableFuture<Reply> started =
        test.isPresent()
            ? robot.submit(new DebugCommand.Debug(_ -> test.get().begin(robot::submit)))
            : robot.submit(
                new ProgramCommand.StartProgram(program, Optional.of(ProgramsFolder.of(file))));
    if (held) {
      pauseAtBegin();
    }
    // told before what the program does
    CompletableFuture<Optional<String>> told = started.thenApplyAsync(Reply::complaint, answers);
    letPass();
    return told;
  }

  /**
   * A test leaves the command that starts it when its turn comes: what holds it is behind that.
   * What calls the test is no line of its file, so it runs to its own first statement.
   */
  private void pauseAtBegin() {
    if (test.isEmpty()) {
      var _ = robot.submit(new DebugCommand.Debug(Debugger::pause));
      return;
    }
    test.get()
        .firstLine()
        .ifPresent(
            line -> {
              var into =
                  new DebugCommand.Debug(
                      debugger -> {
                        debugger.pause();
                        debugger.runTo(Debugger.MAIN, line);
                      });
              Consumer<Debugger> behind =
                  _ -> {
                    var _ = robot.submit(into);
                  };
              var _ = robot.submit(new DebugCommand.Debug(behind));
            });
  }

  private void letPass() {
    passing = true;
    starting = false;
    work.release();
  }

  @Override
  public boolean atSafetyStop() {
    return atSafetyStop;
  }

  @Override
  public void leaveSafetyStop() {
    atSafetyStop = false;
    follower.end();
    letPass();
  }

  @Override
  public void stop() {
    var _ = robot.submit(new ProgramCommand.StopProgram());
    if (atSafetyStop) {
      atSafetyStop = false;
      letPass();
    }
  }

  @Override
  public void holdAfterFrame() {
    hold.wish();
  }

  /** Whether nothing of the program is left. */
  public boolean over() {
    return over;
  }

  @Override
  public <T> CompletableFuture<T> ask(Question<T> question) {
    return link.ask(question);
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
      var _ = clock.awaitDue(frames::waitsForOutside);
      tellLost();
      frames.advance();
    } else {
      work.acquire();
      work.drainPermits();
      clock.startAfresh();
      if (held) {
        frames.advance();
      } else if (passing || starting) {
        return;
      } else {
        frames.applyCommands();
      }
    }
    ControllerState state = drive.state();
    hold.see(state);
    ring.take(state);
    listener.frame(state);
    if (passing && test.isPresent()) {
      test.get().after(state).ifPresent(this::tested);
    } else if (passing && !state.debug().held()) {
      follow(state);
    }
  }

  private void tested(TestResult result) {
    passing = false;
    over = true;
    String name = result.id().name();
    if (result.failure().isEmpty()) {
      listener.note(text("passed", name));
      listener.over(new RunResult(RunResult.DONE, Optional.empty(), Optional.empty(), 0));
      return;
    }
    listener.over(
        new RunResult(
            RunResult.PROGRAM_FAILED,
            Optional.empty(),
            Optional.of(text("isRed", name, result.failure().get().message())),
            0));
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
