package org.pendant.controller.bench;

import static org.pendant.controller.bench.BenchTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.function.Supplier;
import org.pendant.controller.command.Command;
import org.pendant.script.value.ScriptError;
import org.pendant.script.value.Value;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramState;

/**
 * Test bench: what the builtins of a test reach beyond the control box. One stands beside each
 * controller under test; whoever drives the controller carries out what the test asks for here, and
 * tells how the program under test is. Owned by the thread that drives the controller.
 */
public final class TestBench {
  private final int testNumber;
  private final Choices choices;
  private final TestedPrograms programs;
  private final Supplier<SortedMap<String, Value>> globals;
  private final Mocks mocks = new Mocks();
  private final Expected expected = new Expected();
  private final PreparedAnswers answers = new PreparedAnswers();
  private final TestPeers peers = new TestPeers();
  private final RpcPeer rpc = new RpcPeer(mocks.calls());
  private final ModbusDevices devices = new ModbusDevices();
  private final IoChanges changes = new IoChanges();
  private final List<OutputFollower> followers = new ArrayList<>();
  private List<Command> commands = new ArrayList<>();
  private Optional<Program> toStart = Optional.empty();
  private String programName = "";
  private boolean starting;
  private boolean started;
  private boolean elsewhere;
  private ProgramState state = ProgramState.STOPPED;
  private Optional<Ending> ending = Optional.empty();

  /**
   * A bench for one test.
   *
   * @param testNumber which of the tests of its file runs
   * @param choices what is random in the test
   * @param programs finds what the test starts
   * @param globals the global variables of the program under test
   */
  public TestBench(
      int testNumber,
      Choices choices,
      TestedPrograms programs,
      Supplier<SortedMap<String, Value>> globals) {
    this.testNumber = testNumber;
    this.choices = choices;
    this.programs = programs;
    this.globals = globals;
  }

  /** Which of the tests of its file runs. */
  public int testNumber() {
    return testNumber;
  }

  /** What is random in the test. */
  public Choices choices() {
    return choices;
  }

  /** The functions that are replaced. */
  public Mocks mocks() {
    return mocks;
  }

  /** The trouble that the test wants. */
  public Expected expected() {
    return expected;
  }

  /** What the operator says. */
  public PreparedAnswers answers() {
    return answers;
  }

  /** The server of remote procedures that programs reach. */
  public RpcPeer rpc() {
    return rpc;
  }

  /** The Modbus devices that programs reach. */
  public ModbusDevices devices() {
    return devices;
  }

  /** The changes of digital signals so far. */
  public IoChanges changes() {
    return changes;
  }

  /** Whom programs reach by sockets. */
  public TestPeers peers() {
    return peers;
  }

  /** The wires from outputs to inputs. */
  public List<OutputFollower> followers() {
    return followers;
  }

  /** The global variables of the program under test, by name. */
  public SortedMap<String, Value> globals() {
    return globals.get();
  }

  /**
   * Has a program started before the next frame.
   *
   * @throws ScriptError if it cannot be read or does not compile, or one runs
   */
  public void start(String file) throws ScriptError {
    if (running() || toStart.isPresent()) {
      throw new ScriptError("program-runs", text("programRuns"));
    }
    Program program = programs.load(file);
    programName = program.source().name();
    toStart = Optional.of(program);
    started = true;
  }

  /** The file of the program that was started last; empty where none was. */
  public String programName() {
    return programName;
  }

  /** Whether the test has started a program so far. */
  public boolean started() {
    return started;
  }

  /** The program that is to be started, which counts as started from then on. */
  public Optional<Program> takeStart() {
    Optional<Program> taken = toStart;
    toStart = Optional.empty();
    starting |= taken.isPresent();
    return taken;
  }

  /** Has a command carried out before the next frame. */
  public void post(Command command) {
    commands.add(command);
  }

  /** What is to be carried out, in order. */
  public List<Command> takeCommands() {
    if (commands.isEmpty()) {
      return List.of();
    }
    List<Command> taken = commands;
    commands = new ArrayList<>();
    return taken;
  }

  /**
   * Has the program under test run elsewhere: {@link #seeElsewhere} tells how it is, not this box.
   */
  public void runElsewhere() {
    elsewhere = true;
  }

  /** Tells how the program under test is that runs elsewhere. */
  public void seeElsewhere(ProgramState now, Optional<Ending> howEnded) {
    take(now, howEnded);
  }

  /** Tells how the program under test is in this frame, before the test has its part of it. */
  public void see(ProgramState now, Optional<Ending> howEnded) {
    if (!elsewhere) {
      take(now, howEnded);
    }
  }

  private void take(ProgramState now, Optional<Ending> howEnded) {
    starting = false;
    state = now;
    ending = howEnded;
  }

  /** Whether a program under test runs, is paused, or is about to start. */
  public boolean running() {
    return toStart.isPresent() || starting || state != ProgramState.STOPPED;
  }

  /** Whether the program under test is paused. */
  public boolean paused() {
    return state == ProgramState.PAUSED;
  }

  /** How the program under test ended; empty while it runs, and where none was started. */
  public Optional<Ending> ending() {
    return running() ? Optional.empty() : ending;
  }
}
