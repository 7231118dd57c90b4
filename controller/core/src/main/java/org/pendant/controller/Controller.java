package org.pendant.controller;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.concurrent.CompletableFuture;
import java.util.function.BooleanSupplier;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.box.Determinism;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.StateStream;
import org.pendant.language.source.Source;
import org.pendant.script.debug.Debugger;
import org.pendant.script.function.Builtins;
import org.pendant.script.value.Value;
import org.pendant.script.variables.VariableTracer;
import org.pendant.script.vm.InterpreterJournal;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.Machine;
import org.pendant.script.vm.ProgramLoader;

/**
 * One robot controller with its arm. Any number of them live in a process.
 *
 * <p>One thread at a time drives it, frame by frame, with {@link #advance}: a {@link FrameLoop}, or
 * whoever created it. Everybody else reads {@link #state} and submits commands, from any thread.
 */
public final class Controller {
  private final Builtins<ControlBox> builtins;
  private final ControlBox box;
  private final Machine machine;
  private final CommandQueue commandQueue;
  private final InstallationHandler installed;
  private final Frame frame;

  /**
   * Switches a controller on.
   *
   * @throws IllegalArgumentException if the robot, an input or an encoder is not known, or
   *     something is wrong with the installation
   */
  public Controller(ControllerOptions options) {
    this(options, StandardBuiltins.create());
  }

  /** As {@link #Controller(ControllerOptions)}, with a catalogue that may be shared. */
  public Controller(ControllerOptions options, Builtins<ControlBox> builtins) {
    this.builtins = builtins;
    box = new ControlBox(options.boxSetup());
    machine = new Machine(builtins, box, options.memoryBytes());
    installed = new InstallationHandler(box, machine);
    options.installation().ifPresent(installed::begin);
    options.inputs().forEach(this::setInput);
    options.signals().forEach(box.signals()::write);
    installed.takeLevels();
    options.encoders().forEach((index, ticksPerS) -> box.encoders().get(index).run(ticksPerS));
    Debugger debugger = new Debugger(machine);
    ManualControl hand = new ManualControl(box, machine);
    VariableTracer tracer = new VariableTracer(machine);
    commandQueue = new CommandQueue(box, machine, debugger, hand, tracer, installed);
    frame = new Frame(box, machine, debugger, commandQueue, hand, tracer, installed);
  }

  private void setInput(String name, boolean level) {
    Optional<SafetyInput> safety = safetyInput(name);
    if (safety.isPresent()) {
      box.safety().setInput(safety.get(), level);
    } else {
      box.io().setInput(name, level);
    }
  }

  private static Optional<SafetyInput> safetyInput(String name) {
    return Arrays.stream(SafetyInput.values()).filter(each -> each.word().equals(name)).findAny();
  }

  /**
   * What is set up, with the values that programs have left in the installation's variables; any
   * thread. The same object while nothing of it changes.
   */
  public Installation installation() {
    return installed.current();
  }

  /** The functions that programs may call. */
  public Builtins<ControlBox> builtins() {
    return builtins;
  }

  /** Parses, checks and compiles a program; any thread. */
  public LoadResult load(Source source) {
    return ProgramLoader.load(source, builtins);
  }

  /**
   * Leaves a command for the next frame; any thread. What is chained to the reply without an
   * executor runs in the frame loop and must be short.
   */
  public CompletableFuture<Reply> submit(Command command) {
    return commandQueue.post(command).reply();
  }

  /** As {@link #submit}, for who may want to take the command back; any thread. */
  public PendingCommand post(Command command) {
    return commandQueue.post(command);
  }

  /**
   * Has {@code journal} told of every command from now on. Only for the thread that drives the
   * frames.
   */
  public void noteCommandsIn(CommandJournal journal) {
    commandQueue.noteIn(journal);
  }

  /**
   * Whether what has happened can happen once more, with the same options and commands; any thread.
   */
  public Determinism determinism() {
    return box.clock().determinism();
  }

  /** Runs one frame in the calling thread. */
  public void advance() {
    frame.advance();
  }

  /**
   * Runs frames in the calling thread until a condition holds, looked at after each.
   *
   * @param condition usually about {@link #state}
   * @param maxFrames how many frames to run at most
   * @return whether the condition came to hold
   */
  public boolean runUntil(BooleanSupplier condition, long maxFrames) {
    for (long i = 0; i < maxFrames; i++) {
      frame.advance();
      if (condition.getAsBoolean()) {
        return true;
      }
    }
    return false;
  }

  /**
   * Whether a script thread waits for somebody outside, who lives by the wall clock, or Modbus
   * devices are asked again and again. Only for the thread that drives the frames.
   */
  public boolean waitsForOutside() {
    return machine.waitsForOutside() || box.links().modbus().active();
  }

  /** The newest snapshot; any thread. */
  public ControllerState state() {
    return frame.state();
  }

  /** Every snapshot in turn, for who must not miss a frame; any thread. */
  public StateStream feed() {
    return frame.feed();
  }

  /**
   * Log lines after number {@code number} that are still kept, oldest first; any thread. The number
   * of the first tells how many were missed.
   */
  public List<LogEntry> logSince(long number) {
    return box.log().since(number);
  }

  /** What has happened in interpreter mode; any thread. */
  public InterpreterJournal interpreterJournal() {
    return machine.interpreter().journal();
  }

  /** The text of the running or last program. Only for the thread that drives the frames. */
  public Optional<Source> programSource() {
    return machine.source();
  }

  /**
   * Copies of the global variables of the running or last program, by name. Only for the thread
   * that drives the frames.
   */
  public SortedMap<String, Value> globals() {
    return machine.globals();
  }
}
