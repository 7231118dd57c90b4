package org.pendant.controller;

import static org.pendant.controller.ControllerTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.eip.AssemblyWatchdog;
import org.pendant.controller.io.InputWatchdogs;
import org.pendant.controller.rtde.PublishedState;
import org.pendant.controller.safety.FrameFacts;
import org.pendant.controller.safety.SafetyAction;
import org.pendant.controller.state.ControlMode;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.ProgramStatus;
import org.pendant.controller.state.RuntimeState;
import org.pendant.controller.state.SafetyStatus;
import org.pendant.controller.state.StateStream;
import org.pendant.language.source.SourceRange;
import org.pendant.models.arm.JointNumbers;
import org.pendant.motion.MotionFailure;
import org.pendant.script.debug.Debugger;
import org.pendant.script.value.Value;
import org.pendant.script.variables.VariableTracer;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.Machine;
import org.pendant.script.vm.ProgramState;
import org.pendant.script.vm.ScriptFailure;

/**
 * Frame of 2 ms: everything that happens in it, in its order. One thread at a time calls {@link
 * #advance}.
 */
final class Frame {
  private static final double NS = 1e-9;

  private final ControlBox box;
  private final Machine machine;
  private final CommandQueue commandQueue;
  private final ManualControl hand;
  private final InstallationHandler installed;

  /** Made once, since every frame hands it on. */
  private final Consumer<String> warn;

  private final Runnable follow = this::followProgram;

  private final StopSnapshot witness = new StopSnapshot();

  private final JointNumbers targetSpeedRadPerS = new JointNumbers();

  private final RuntimeStateTracker runtime = new RuntimeStateTracker();
  private ProgramState followed = ProgramState.STOPPED;
  private ProgramStatus program = ProgramStatus.NONE;
  private Optional<Ending> internalEnding = Optional.empty();

  /** Commands that have arrived are left for the next frame. */
  private boolean beforeCommands;

  /** The next frame has begun already. */
  private boolean begun;

  /** A debugger has paused the program in the frame that has begun. */
  private boolean held;

  /** The program is paused because a safety function stopped the arm. */
  private boolean heldBySafety;

  private boolean stoppedUnexpectedly;

  /** When this frame began by the computer's clock; in virtual time nothing depends on it. */
  private long beganNs = System.nanoTime();

  private final StateStream feed = new StateStream();
  private final FrameImage image;

  Frame(
      ControlBox box,
      Machine machine,
      Debugger debugger,
      CommandQueue commandQueue,
      ManualControl hand,
      VariableTracer tracer,
      InstallationHandler installed) {
    this.box = box;
    this.machine = machine;
    this.commandQueue = commandQueue;
    this.hand = hand;
    this.installed = installed;
    warn = box.log()::warning;
    image = new FrameImage(box, machine, debugger, tracer);
    take();
    feed.publish(state());
    box.links().setPublished(new PublishedState(this::state));
  }

  void advance() {
    try {
      step();
    } catch (OutOfMemoryError | StackOverflowError e) {
      endOrThrow(e);
    }
  }

  /** As {@link #advance}, without the commands that have arrived. */
  void advanceBeforeCommands() {
    beforeCommands = true;
    try {
      advance();
    } finally {
      beforeCommands = false;
    }
  }

  /** Whatever met it: it is the program that takes so much, and without it the box continues. */
  private void endOrThrow(VirtualMachineError e) {
    if (machine.state() == ProgramState.STOPPED) {
      throw e;
    }
    endAfter(e);
  }

  /**
   * Carries out the commands that have arrived, between two frames: no time passes. A frame that a
   * debugger pauses in continues with them.
   */
  void applyCommands() {
    if (held) {
      advance();
      return;
    }
    try {
      beganNs = box.clock().inRealTime() ? System.nanoTime() : 0;
      commandQueue.drain(follow);
      commandQueue.runSecondaries();
      followProgram();
      publish();
    } catch (OutOfMemoryError | StackOverflowError e) {
      endOrThrow(e);
    }
  }

  private void step() {
    beganNs = box.clock().inRealTime() ? System.nanoTime() : 0;
    if (!held && !begun) {
      begin();
    }
    begun = false;
    takeInputs();
    held = runScripts();
    if (held) {
      // a debugger has paused the program: time stands still, and the next call continues with it
      commandQueue.refuseSecondaries(text("debuggerPaused", machine.programName()));
      publish();
      return;
    }
    stepMotion();
    stepArm();
    checkSafety();
    publish();
  }

  /** Begins the next frame; those that share a cell begin theirs together before they go on. */
  void begin() {
    box.beginFrame();
    box.links().stepCell();
    begun = true;
  }

  /** The newest snapshot; any thread. */
  ControllerState state() {
    return image.state();
  }

  /** The program in the newest snapshot; the thread that drives alone. */
  ProgramStatus program() {
    return program;
  }

  /** Whether the newest snapshot has new log lines or popups; the thread that drives alone. */
  boolean broughtMessages() {
    return image.broughtMessages();
  }

  /** Whether arm and cell stood still in the last frame. */
  boolean still() {
    return image.still();
  }

  /** Every snapshot in turn; any thread. */
  StateStream feed() {
    return feed;
  }

  private void takeInputs() {
    box.links().modbus().step(box.clock().timeS());
    box.links().toolLine().step();
    if (beforeCommands) {
      commandQueue.leave();
    } else {
      commandQueue.drain(follow);
    }
    box.signals().player().step(warn);
    installed.step();
    followWatchdogs();
    followAssemblies();
    box.signals().runState().power(box.drive().powered());
    followProgram();
  }

  /** Inputs that were not written in time hold or end the program. */
  private void followWatchdogs() {
    boolean running = machine.state() == ProgramState.RUNNING;
    List<InputWatchdogs.Violation> all =
        box.links().inputWatchdogs().step(running, box.clock().timeS());
    if (!all.isEmpty()) {
      all.forEach(this::follow);
    }
  }

  private void follow(InputWatchdogs.Violation late) {
    String input = late.input();
    String leastHz = Value.of(late.leastHz()).text();
    switch (late.action()) {
      case IGNORE -> box.log().warning(text("inputLateIgnored", input, leastHz));
      case PAUSE -> {
        box.log().error(text("inputLatePauses", input, leastHz));
        machine.pause();
      }
      case STOP -> {
        box.log().error(text("inputLateEnds", input, leastHz));
        machine.stop();
      }
    }
  }

  /** Assemblies that no scanner has written in time stop the arm and hold or end the program. */
  private void followAssemblies() {
    boolean running = machine.state() == ProgramState.RUNNING;
    List<AssemblyWatchdog.Violation> all =
        box.links().assemblies().step(running, box.clock().timeS());
    if (!all.isEmpty()) {
      all.forEach(this::follow);
    }
  }

  private void follow(AssemblyWatchdog.Violation late) {
    int instance = late.instance();
    String leastHz = Value.of(late.leastHz()).text();
    switch (late.action()) {
      case IGNORE -> box.log().warning(text("instanceLateIgnored", instance, leastHz));
      case PAUSE -> {
        box.log().error(text("instanceLatePauses", instance, leastHz));
        box.safety().protectiveStop();
        machine.pause();
      }
      case STOP -> {
        box.log().error(text("instanceLateEnds", instance, leastHz));
        box.safety().protectiveStop();
        machine.stop();
      }
    }
  }

  /** Whether a debugger has paused the scripts in the middle of this frame. */
  private boolean runScripts() {
    try {
      if (machine.advance()) {
        return true;
      }
    } catch (RuntimeException | Error e) {
      endAfter(e);
    }
    if (box.prompts().popups().blocked()) {
      machine.pause();
    }
    commandQueue.runSecondaries();
    followProgram();
    advanceCompanion();
    return false;
  }

  /** A test sees the program under test as it is in this frame. */
  private void advanceCompanion() {
    if (machine.companion().running()) {
      box.environment()
          .testBench()
          .ifPresent(bench -> bench.see(machine.state(), machine.ending()));
      machine.companion().advance();
    }
  }

  private void stepMotion() {
    box.offsets().encoders().step(box.signals().digital());
    if (machine.state() == ProgramState.STOPPED) {
      box.modes().forceMode().finish();
    }
    box.motion().step();
    box.modes().forceMode().follow();
    hand.step();
  }

  private void stepArm() {
    box.drive().step();
  }

  private void checkSafety() {
    int line = machine.line();
    Optional<MotionFailure> lost = box.motion().takeNewFault();
    if (lost.isPresent()) {
      box.safety().lostPath(lost.get());
    }
    if (box.safety().isShutDown()) {
      stopProgram();
    }
    SafetyAction action = box.safety().step(facts());
    if (lost.isPresent()) {
      // whatever stop there was before, and before the arm is halted: ending releases its halt
      stopProgram();
    }
    switch (action) {
      case NONE -> {}
      case PAUSE -> pauseProgram();
      case STOP_ON_PATH -> {
        heldBySafety |= pauseProgram();
        if (box.safety().stoppedByProgram() && machine.nothingLeft()) {
          // it would wait to be resumed and do nothing
          stopProgram();
        }
        box.motion().halt(box.safety().stopDecelerationRadPerS2());
      }
      case STOP_ON_PATH_THEN_OFF -> {
        stopProgram();
        box.motion().halt(box.safety().stopDecelerationRadPerS2());
      }
      case OFF_NOW -> stopProgram();
      case RESUME -> resumeProgram();
    }
    followStop();
    witness.look(box, line);
    box.drive().settle();
  }

  private FrameFacts facts() {
    box.motion().readSpeedRadPerS(targetSpeedRadPerS);
    return new FrameFacts(
        box.clock().timeS(),
        box.drive().drivenNow(),
        targetSpeedRadPerS,
        box.arm().simulated().sensors(),
        box.flange().tool().inFlange(),
        box.flange().wrenchInBase(),
        box.motion().steady(),
        box.motion().moving(),
        machine.state() == ProgramState.RUNNING,
        box.modes().freedrive().active() || box.motion().torqueDriven(),
        box.modes().forceMode().active());
  }

  /** Holds the program if it runs; returns whether it did. */
  private boolean pauseProgram() {
    boolean running = machine.state() == ProgramState.RUNNING;
    machine.pause();
    followProgram();
    return running;
  }

  private void stopProgram() {
    machine.stop();
    followProgram();
  }

  /** What paused the program is over by itself. */
  private void resumeProgram() {
    boolean waits = machine.state() == ProgramState.PAUSED || machine.pausing();
    if (heldBySafety && waits && !box.prompts().popups().blocked()) {
      machine.resume();
      followProgram();
    }
  }

  private boolean failed() {
    return machine.ending().isPresent() && machine.ending().get() instanceof Ending.Failed;
  }

  private void publish() {
    take();
    commandQueue.reply();
    if (feed.hasFollowers()) {
      feed.publish(state());
    }
  }

  private void take() {
    image.take(executionTimeS(), controlMode(), safetyStatus(), programStatus());
  }

  /** Makes the motion do what the program's state asks for. */
  private void followProgram() {
    ProgramState now = machine.state();
    if (now == followed) {
      return;
    }
    ProgramState before = followed;
    followed = now;
    switch (now) {
      case RUNNING -> {
        internalEnding = Optional.empty();
        heldBySafety = false;
        box.signals().runState().started(before == ProgramState.PAUSED);
        if (before == ProgramState.STOPPED) {
          box.signals().player().programStarted();
        }
        box.motion().resume();
      }
      case PAUSED -> {
        box.modes().freedrive().end();
        box.signals().runState().held(unexpected());
        box.motion().pause();
      }
      case STOPPED -> {
        box.programStopped();
        box.signals().player().programEnded();
        installed.programEnded();
        box.modes().freedrive().end();
        box.motion().abort();
        box.motion().endOffsets();
        box.motion().resume();
        closePopups();
        box.safety().programStopped();
        box.signals().runState().held(unexpected());
        if (machine.ending().orElseThrow() instanceof Ending.Failed failed) {
          ScriptFailure why = failed.failure();
          box.log()
              .ending(
                  why.code(),
                  text("programFailed", machine.programName(), why.line(), why.message()),
                  machine.failurePlace());
        }
      }
    }
  }

  /** What a program says on its last line stays to be read, unless it has been stopped. */
  private void closePopups() {
    switch (machine.ending().orElseThrow()) {
      case Ending.Stopped stopped -> box.prompts().popups().closeAll();
      case Ending.Finished finished -> box.prompts().popups().closeBlocking();
      case Ending.Halted halted -> box.prompts().popups().closeBlocking();
      case Ending.Failed failed -> box.prompts().popups().closeBlocking();
    }
  }

  /** Whether something unplanned pauses or ends the program (manual 19.6). */
  private boolean unexpected() {
    return failed()
        || internalEnding.isPresent()
        || box.motion().fault().isPresent()
        || unexpectedStop();
  }

  private boolean unexpectedStop() {
    return switch (box.safety().safetyMode()) {
      case PROTECTIVE_STOP, VIOLATION, FAULT -> true;
      case NORMAL,
          REDUCED,
          RECOVERY,
          SAFEGUARD_STOP,
          SYSTEM_EMERGENCY_STOP,
          ROBOT_EMERGENCY_STOP,
          VALIDATE_JOINT_ID,
          UNDEFINED,
          AUTOMATIC_MODE_SAFEGUARD_STOP,
          SYSTEM_THREE_POSITION_ENABLING_STOP,
          TEACH_PENDANT_THREE_POSITION_ENABLING_STOP ->
          false;
    };
  }

  /** A program that has just been paused, by a request for a stop say, meets the stop itself. */
  private void followStop() {
    boolean before = stoppedUnexpectedly;
    stoppedUnexpectedly = unexpectedStop();
    if (stoppedUnexpectedly && !before && followed == ProgramState.PAUSED) {
      box.signals().runState().held(true);
    }
  }

  /**
   * Our own mistake, not the program's: it ends, and the log gets all there is to know. Of a
   * program that has used up Java's memory it gets what the program was at.
   */
  private void endAfter(Throwable cause) {
    int line = Math.max(1, machine.line());
    boolean full = cause instanceof OutOfMemoryError;
    held = false;
    if (full) {
      // first of all: for anything else there is room only when the values are gone
      machine.abandon();
      box.log().error(text("programLine", machine.programName(), line, text("outOfMemory")));
    } else {
      box.log().internalError(cause);
      machine.stop();
    }
    box.clock().determinism().taint(text("endedByError"));
    internalEnding =
        Optional.of(
            new Ending.Failed(
                new ScriptFailure(
                    full ? "out-of-memory" : "internal-error",
                    full ? text("outOfMemory") : text("internalError", cause),
                    new SourceRange(0, 0),
                    line,
                    1,
                    List.of())));
  }

  /** The last status again while nothing has changed. */
  private SafetyStatus safetyStatus() {
    SafetyStatus last = image.safety();
    return last.holdsFor(box, witness.place()) ? last : SafetyStatus.of(box, witness.place());
  }

  private double executionTimeS() {
    return box.clock().inRealTime()
        ? NS * (System.nanoTime() - beganNs)
        : box.clock().executionTimeS(machine.state() == ProgramState.RUNNING);
  }

  private ControlMode controlMode() {
    if (box.modes().freedrive().active()) {
      return ControlMode.TEACH;
    }
    if (box.motion().torqueDriven()) {
      return ControlMode.TORQUE;
    }
    return box.modes().forceMode().active() ? ControlMode.FORCE : ControlMode.POSITION;
  }

  /** The last status again while nothing has changed: most frames wait. */
  private ProgramStatus programStatus() {
    ProgramState now = machine.state();
    int line = machine.line();
    Optional<Ending> ending = internalEnding.isPresent() ? internalEnding : machine.ending();
    RuntimeState doing =
        runtime.look(now, machine.pausing(), box.motion().turning(), box.motion().scaling());
    if (now != program.state()
        || doing != program.runtime()
        || line != program.line()
        || !ending.equals(program.ending())
        || !machine.programName().equals(program.name())) {
      program = new ProgramStatus(now, doing, machine.programName(), line, ending);
    }
    return program;
  }
}
