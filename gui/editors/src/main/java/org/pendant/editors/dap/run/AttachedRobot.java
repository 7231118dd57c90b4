package org.pendant.editors.dap.run;

import static org.pendant.editors.dap.run.DebuggedRunTexts.text;

import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Executor;
import java.util.concurrent.atomic.AtomicReference;
import org.pendant.controller.Deadline;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.Robot;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.StateStream;
import org.pendant.language.source.Source;
import org.pendant.recording.Recording;
import org.pendant.recording.RecordingRing;
import org.pendant.script.debug.Debugger;
import org.pendant.script.vm.ProgramEvent;
import org.pendant.script.vm.ProgramState;

/**
 * Attached robot: one that others drive. A thread follows its snapshots; programs come and go. What
 * was left of the debugger is taken away when it is closed, and a held program goes on.
 */
public final class AttachedRobot implements DebuggedRobot {
  /** Memory of the recording: some minutes of an arm that never rests. */
  private static final long RECORDING_BYTES = 64L << 20;

  private final AttachableRobot attachable;
  private final Robot robot;
  private final RunListener listener;
  private final DebuggerLink link;
  private final HoldAfterFrame hold;
  private final RecordingRing ring;
  private final StateStream.Subscription frames;
  private final Thread thread;

  /** The text of the newest program, as the frame loop has told it. */
  private final AtomicReference<Optional<Source>> text = new AtomicReference<>(Optional.empty());

  private volatile Optional<FrameWatch> watch = Optional.empty();
  private volatile boolean stopAtSafetyStops;
  private volatile boolean atSafetyStop;

  /** What others had wished before; only for the frame loop. */
  private boolean stoppedOnErrors;

  /** Only for the thread that follows. */
  private boolean safetyStopped;

  private AttachedRobot(AttachableRobot attachable, RunListener listener, Executor answers) {
    this.attachable = attachable;
    this.listener = listener;
    robot = attachable.robot();
    link = new DebuggerLink(robot, answers);
    hold = new HoldAfterFrame(robot);
    ring = new RecordingRing(robot.state(), text::get, RECORDING_BYTES);
    frames = robot.feed().follow();
    thread = Thread.ofPlatform().daemon().name("attached robot").unstarted(this::follow);
  }

  /**
   * Begins to follow.
   *
   * @param answers takes what comes of questions
   * @throws IllegalArgumentException if another editor is attached
   */
  public static AttachedRobot begin(
      AttachableRobot attachable, RunListener listener, Executor answers) {
    if (!attachable.take()) {
      throw new IllegalArgumentException(text("anotherEditor"));
    }
    AttachedRobot attached = new AttachedRobot(attachable, listener, answers);
    attached.thread.start();
    var _ = attached.robot.submit(new DebugCommand.Debug(attached::come));
    return attached;
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
  public <T> CompletableFuture<T> ask(Question<T> question) {
    return link.ask(question);
  }

  /** The text of the running or last program. */
  public CompletableFuture<Optional<Source>> program() {
    return ask(debugger -> attachable.program().get());
  }

  /** The text of the program that has started last since this follows the robot. */
  public Optional<Source> startedText() {
    return text.get();
  }

  private void follow() {
    try {
      while (!frames.closed()) {
        ControllerState state = frames.take();
        if (frames.closed()) {
          return;
        }
        see(state);
      }
    } catch (InterruptedException e) {
      // close() asked for it
      Thread.currentThread().interrupt();
    } catch (RuntimeException | Error e) {
      listener.failed(e);
    }
  }

  private void see(ControllerState state) throws InterruptedException {
    if (state.newProgramEvents().stream().anyMatch(ProgramEvent.Started.class::isInstance)) {
      learnText();
    }
    hold.see(state);
    if (watch.isPresent() && !state.debug().held()) {
      var _ = robot.submit(new DebugCommand.Debug(watch.get()::look));
    }
    ring.take(state);
    listener.frame(state);
    seeSafety(state);
  }

  /** Asks the frame loop, which comes to it in the next frame. */
  private void learnText() {
    var _ =
        robot.ask(
            new DebugCommand.Debug(debugger -> text.set(attachable.program().get())),
            Deadline.orNever(Duration.ofSeconds(1)));
  }

  @Override
  public void watch(Optional<FrameWatch> watch) {
    this.watch = watch;
  }

  @Override
  public void holdAfterFrame() {
    hold.wish();
  }

  @Override
  public void stopAtSafetyStops(boolean wanted) {
    stopAtSafetyStops = wanted;
  }

  @Override
  public boolean atSafetyStop() {
    return atSafetyStop;
  }

  /** Others see to the safety stops of this robot, and let the program go on or end it. */
  @Override
  public void leaveSafetyStop() {
    atSafetyStop = false;
  }

  private void seeSafety(ControllerState state) {
    boolean stopped =
        state.safety().stop().isPresent() && state.program().state() != ProgramState.STOPPED;
    if (stopped && !safetyStopped && stopAtSafetyStops) {
      atSafetyStop = true;
      listener.safetyStop(state);
    } else if (!stopped && atSafetyStop) {
      atSafetyStop = false;
      listener.wentOn();
    }
    safetyStopped = stopped;
  }

  @Override
  public void stop() {
    var _ = robot.submit(new ProgramCommand.StopProgram());
  }

  @Override
  public void close() {
    frames.close();
    thread.interrupt();
    boolean interrupted = false;
    while (thread.isAlive()) {
      try {
        thread.join();
      } catch (InterruptedException e) {
        interrupted = true;
      }
    }
    var _ = robot.submit(new DebugCommand.Debug(this::leave));
    attachable.giveBack();
    if (interrupted) {
      Thread.currentThread().interrupt();
    }
  }

  private void come(Debugger debugger) {
    stoppedOnErrors = debugger.stopsOnErrors();
    debugger.followCalls(true);
    debugger.share(true);
  }

  /** Breakpoints may be those of others: who has set some takes them away itself. */
  private void leave(Debugger debugger) {
    debugger.stopOnErrors(stoppedOnErrors);
    debugger.followCalls(false);
    debugger.share(false);
    if (debugger.state().held()) {
      debugger.resume();
    }
  }
}
