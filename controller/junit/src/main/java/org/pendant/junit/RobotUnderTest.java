package org.pendant.junit;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.opentest4j.AssertionFailedError;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.io.InputOwners;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.io.SignalText;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.models.time.FrameTime;
import org.pendant.project.program.file.BrokenTree;
import org.pendant.project.program.file.TreeFile;
import org.pendant.recording.Recording;
import org.pendant.recording.RecordingRing;
import org.pendant.script.value.Value;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramState;

/**
 * Robot under test: a robot with its controller, in virtual time: it stands still until the test
 * lets time pass, and then goes as fast as the processor does. Everything that it does is recorded.
 *
 * <p>What is wrong with a program is an {@link AssertionFailedError} that says where; what is wrong
 * with a call is an {@link IllegalArgumentException}. Belongs to one thread.
 */
public final class RobotUnderTest {
  /** How long a program may run in robot time where a test does not say. */
  public static final Duration USUAL_TIME = Duration.ofMinutes(5);

  private final Controller controller;
  private final RecordingRing ring;

  /** Switches a robot on; most tests have {@link Robot} do it. */
  public RobotUnderTest(ControllerOptions options) {
    controller = new Controller(options);
    ring = new RecordingRing(controller.state(), controller::programSource);
  }

  /**
   * Starts a program from a file, {@code .script}, {@code .pendant} or {@code .urp}, as the play
   * button does.
   *
   * @throws IOException if it cannot be read
   */
  public RobotUnderTest start(Path file) throws IOException {
    byte[] bytes = Files.readAllBytes(file);
    String name = file.getFileName().toString();
    ProgramsFolder folder = ProgramsFolder.of(file.toString());
    if (!TreeFile.hasEnding(name)) {
      return start(Source.of(name, bytes), folder);
    }
    try {
      TreeFile tree = TreeFile.read(name, bytes);
      if (!tree.problems().isEmpty()) {
        throw new AssertionFailedError(String.join("\n", tree.problems()));
      }
      return start(Source.of(tree.scriptName(), tree.script().text()), folder);
    } catch (BrokenTree e) {
      throw new AssertionFailedError(String.join("\n", e.reports()), e);
    }
  }

  /** Starts a program that is a text. */
  public RobotUnderTest start(String script) {
    return start(Source.of("program.script", script), ProgramsFolder.NONE);
  }

  private RobotUnderTest start(Source source, ProgramsFolder folder) {
    LoadResult loaded = controller.load(source);
    Program program =
        loaded
            .program()
            .orElseThrow(
                () ->
                    new AssertionFailedError(
                        loaded.diagnostics().stream()
                            .filter(Diagnostic::isError)
                            .map(each -> told(source, each))
                            .collect(Collectors.joining("\n"))));
    return tell(new ProgramCommand.StartProgram(program, Optional.of(folder)));
  }

  private static String told(Source source, Diagnostic diagnostic) {
    int start = diagnostic.range().start();
    return source.name()
        + ":"
        + source.line(start)
        + ":"
        + source.column(start)
        + ": "
        + ByteText.decoded(diagnostic.message());
  }

  /**
   * Has a command carried out, in a frame of its own.
   *
   * @throws IllegalArgumentException if it is refused
   */
  public RobotUnderTest tell(Command command) {
    CompletableFuture<Reply> reply = controller.submit(command);
    step();
    Optional<String> complaint = reply.join().complaint();
    if (complaint.isPresent()) {
      throw new IllegalArgumentException(complaint.get());
    }
    return this;
  }

  /**
   * Sets an input, in a frame of its own.
   *
   * @param name such as {@code digital_in[0]}, {@code analog_in[1]} or {@code
   *     input_float_register[3]}
   * @param value as {@code pendant run --input} takes it: {@code true}, {@code 5V}, {@code 0.3}
   * @throws IllegalArgumentException if there is no such input, or it does not take this value
   */
  public RobotUnderTest setInput(String name, String value) {
    return tell(new IoCommand.WriteSignals(InputOwners.BY_HAND, SignalText.input(name, value)));
  }

  /** Sets a digital input, as {@link #setInput(String, String)} does. */
  public RobotUnderTest setInput(String name, boolean level) {
    return setInput(name, Boolean.toString(level));
  }

  /** Lets robot time pass, rounded up to whole frames. */
  public RobotUnderTest advance(Duration time) {
    long frames = FrameTime.framesFor(time.toNanos() * 1e-9);
    for (long i = 0; i < frames; i++) {
      step();
    }
    return this;
  }

  /**
   * Lets robot time pass until something is so.
   *
   * @param within how long at most
   * @throws AssertionFailedError if it is not so in time
   */
  public RobotUnderTest advanceUntil(Predicate<ControllerState> condition, Duration within) {
    long frames = FrameTime.framesFor(within.toNanos() * 1e-9);
    for (long i = 0; !condition.test(state()); i++) {
      if (i >= frames) {
        throw new AssertionFailedError(
            "not within " + within.toMillis() / 1e3 + " s of robot time");
      }
      step();
    }
    return this;
  }

  /**
   * Lets robot time pass until the program has ended.
   *
   * @throws AssertionFailedError if it fails, or does not end within {@link #USUAL_TIME}
   */
  public RobotUnderTest runToEnd() {
    return runToEnd(USUAL_TIME);
  }

  /** As {@link #runToEnd()}, within another time. */
  public RobotUnderTest runToEnd(Duration within) {
    advanceUntil(each -> each.program().state() == ProgramState.STOPPED, within);
    if (state().program().ending().orElse(new Ending.Finished())
        instanceof Ending.Failed(var why)) {
      throw new AssertionFailedError(
          state().program().name()
              + ", line "
              + why.line()
              + ": "
              + ByteText.decoded(why.message()));
    }
    return this;
  }

  private void step() {
    controller.advance();
    ring.take(controller.state());
  }

  /** Everything about the robot at the end of the last frame. */
  public ControllerState state() {
    return controller.state();
  }

  /** Robot time since the robot was switched on, s. */
  public double timeS() {
    return state().timeS();
  }

  /**
   * The level of a standard digital output.
   *
   * @param number 0 to 7
   */
  public boolean output(int number) {
    Signal output = new Signal(SignalBank.STANDARD_OUT, number);
    return (state().io().bits(output.bank()) >> output.index() & 1) != 0;
  }

  /** A global variable of the running or last program; empty for one without a value. */
  public Optional<Value> variable(String name) {
    return Optional.ofNullable(controller.globals().get(name));
  }

  /** The lines of the log, oldest first. */
  public List<String> log() {
    return controller.logSince(0).stream().map(LogEntry::text).map(ByteText::decoded).toList();
  }

  /** Every frame so far, or the last ones of a long test. */
  public Recording recording() {
    return ring.recording();
  }

  /** Where the robot is and what it has said last, for the report of a red test. */
  String summary() {
    List<String> lines = log();
    return String.format(
            "robot time %.3f s, program %s %s in line %d",
            timeS(), state().program().name(), state().program().state(), state().program().line())
        + lines.stream()
            .skip(Math.max(0, lines.size() - 20))
            .map(each -> "\n  " + each)
            .collect(Collectors.joining());
  }
}
