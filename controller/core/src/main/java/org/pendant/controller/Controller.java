package org.pendant.controller;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.concurrent.CompletableFuture;
import org.pendant.controller.bench.TestBench;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.box.Determinism;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.eip.AssemblyCommandHandler;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.io.IoCommandHandler;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.safety.SafetyCommandHandler;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.ProgramStatus;
import org.pendant.controller.state.StateStream;
import org.pendant.language.source.Source;
import org.pendant.script.coverage.Coverage;
import org.pendant.script.debug.Debugger;
import org.pendant.script.function.Builtins;
import org.pendant.script.value.Value;
import org.pendant.script.variables.VariableTracer;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.InterpreterJournal;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.Machine;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramLoader;
import org.pendant.script.vm.ProgramState;

/**
 * Controller of one robot with its arm. Any number of them live in a process.
 *
 * <p>One thread at a time drives it by {@link Drive}: a {@link FrameLoop}, or the thread that
 * created it. Everybody else has it as a {@link Robot}.
 */
public final class Controller implements Robot, Drive {
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
    options
        .encoders()
        .forEach((index, ticksPerS) -> box.offsets().encoders().get(index).run(ticksPerS));
    Debugger debugger = new Debugger(machine, box.log()::logpoint);
    ManualControl hand = new ManualControl(box, machine);
    VariableTracer tracer = new VariableTracer(machine);
    commandQueue = commandQueue(debugger, hand, tracer);
    frame = new Frame(box, machine, debugger, commandQueue, hand, tracer, installed);
    box.links().devices().reach(new CellAdapter(box, installed, frame::state));
  }

  private CommandQueue commandQueue(Debugger debugger, ManualControl hand, VariableTracer tracer) {
    return new CommandQueue(
        box.clock(),
        box.log(),
        machine.interpreter(),
        debugger,
        new ProgramCommandHandler(box, machine, hand),
        List.of(
            new SafetyCommandHandler(box.safety(), machine::stop),
            new IoCommandHandler(box.signals(), this::activeProgram),
            new RtdeCommandHandler(box),
            new AssemblyCommandHandler(box.links().assemblies(), box.clock()::timeS),
            new MessageCommandHandler(box, machine),
            new WorldCommandHandler(box),
            new BoxCommandHandler(box),
            hand,
            new InterpreterCommandHandler(machine.interpreter()),
            new DebugCommandHandler(debugger, tracer),
            new InstallationCommandHandler(box, hand, installed)));
  }

  private Optional<String> activeProgram() {
    return machine.state() == ProgramState.STOPPED
        ? Optional.empty()
        : Optional.of(machine.programName());
  }

  private void setInput(String name, boolean level) {
    Optional<SafetyInput> safety = safetyInput(name);
    if (safety.isPresent()) {
      box.safety().setInput(safety.get(), level);
    } else {
      box.signals().digital().setInput(name, level);
    }
  }

  private static Optional<SafetyInput> safetyInput(String name) {
    return Arrays.stream(SafetyInput.values()).filter(each -> each.word().equals(name)).findAny();
  }

  @Override
  public Installation installation() {
    return installed.current();
  }

  @Override
  public SafetyConfiguration safety() {
    return box.safety().configuration();
  }

  @Override
  public Builtins<ControlBox> builtins() {
    return builtins;
  }

  @Override
  public LoadResult load(Source source) {
    return ProgramLoader.load(source, builtins);
  }

  @Override
  public Reply ask(Command command, Deadline deadline) {
    return commandQueue.ask(command, deadline);
  }

  @Override
  public CompletableFuture<Reply> submit(Command command) {
    return commandQueue.post(command).reply();
  }

  @Override
  public PendingCommand post(Command command) {
    return commandQueue.post(command);
  }

  /** Puts this controller under test, before its first frame: {@code bench} is what a test asks. */
  public void attach(TestBench bench) {
    box.environment().attach(bench);
  }

  /**
   * Starts a program beside the primary one, frame by frame after it; the thread that drives calls
   * this, between two frames.
   *
   * @throws IllegalStateException while another one runs there
   */
  public void startCompanion(Program program) {
    machine.companion().start(program);
  }

  /** How the program beside the primary one ended; empty while it runs, and before the first. */
  public Optional<Ending> companionEnding() {
    return machine.companion().ending();
  }

  /** What the program beside the primary one has reached; empty of one without coverage. */
  public Optional<Coverage> companionCoverage() {
    return machine.companion().coverage();
  }

  @Override
  public void noteCommandsIn(CommandJournal journal) {
    commandQueue.noteIn(journal);
  }

  @Override
  public void wakeBy(Runnable wake) {
    commandQueue.wakeBy(wake);
    frame.feed().wakeBy(wake);
  }

  /** As a command, so that a run that is repeated hears of it at the same place. */
  @Override
  public void noteLostTime(double sinceStartS) {
    noteLostTime(sinceStartS, true);
  }

  /**
   * As the other one.
   *
   * @param told whether the log says so
   */
  void noteLostTime(double sinceStartS, boolean told) {
    var _ = submit(new BoxCommand.NoteLostTime(sinceStartS, told));
  }

  /** The control box, for the cell that this controller shares with others. */
  ControlBox box() {
    return box;
  }

  /** Begins the next frame before {@link #advance} runs it. */
  void beginFrame() {
    frame.begin();
  }

  @Override
  public Determinism determinism() {
    return box.clock().determinism();
  }

  @Override
  public void advance() {
    frame.advance();
  }

  @Override
  public void advanceBeforeCommands() {
    frame.advanceBeforeCommands();
  }

  @Override
  public void applyCommands() {
    frame.applyCommands();
  }

  @Override
  public boolean waitsForOutside() {
    return machine.waitsForOutside() || box.links().modbus().reachOutside();
  }

  @Override
  public boolean needsNoFrameOnTime() {
    return machine.state() != ProgramState.RUNNING
        && !machine.companion().running()
        && frame.still()
        && !followed()
        && !waitsForOutside();
  }

  @Override
  public boolean followed() {
    return frame.feed().followed();
  }

  @Override
  public ControllerState state() {
    return frame.state();
  }

  @Override
  public double timeS() {
    return box.clock().timeS();
  }

  @Override
  public ProgramStatus program() {
    return frame.program();
  }

  @Override
  public boolean broughtMessages() {
    return frame.broughtMessages();
  }

  @Override
  public StateStream feed() {
    return frame.feed();
  }

  @Override
  public List<LogEntry> logSince(long number) {
    return box.log().since(number);
  }

  @Override
  public InterpreterJournal interpreterJournal() {
    return machine.interpreter().journal();
  }

  @Override
  public Optional<Source> programSource() {
    return machine.source();
  }

  @Override
  public SortedMap<String, Value> globals() {
    return machine.globals();
  }

  @Override
  public Optional<Coverage> coverage() {
    return machine.coverage();
  }
}
