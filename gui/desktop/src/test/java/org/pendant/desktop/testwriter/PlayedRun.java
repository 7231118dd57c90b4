package org.pendant.desktop.testwriter;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.message.Operator;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.Source;
import org.pendant.recording.RecordingRing;
import org.pendant.recording.replay.Journal;
import org.pendant.script.vm.Program;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.TestResult;
import org.pendant.testing.run.Goldens;
import org.pendant.testing.run.TestRunner;
import org.pendant.testing.run.TestSettings;

/** A controller as the window has it, recorded while somebody plays the operator. */
final class PlayedRun {
  static final String PROGRAM = "pick.script";

  private final Controller controller =
      new Controller(
          ControllerOptions.headless()
              .withOperator(Operator.present())
              .withMeasuredNoise(true)
              .withStartRamp(true));
  private final Journal journal = Journal.of(controller);
  private final RecordingRing ring =
      new RecordingRing(controller.state(), controller::programSource);
  private String text = "";

  PlayedRun frames(int count) {
    for (int i = 0; i < count; i++) {
      controller.advance();
      ring.take(controller.state());
    }
    return this;
  }

  PlayedRun start(String... lines) {
    text = "def pick():\n" + String.join("\n", lines) + "\nend\n";
    Program program = controller.load(Source.of(PROGRAM, text)).program().orElseThrow();
    return ask(new ProgramCommand.StartProgram(program));
  }

  /** Takes effect in the next frame. */
  PlayedRun ask(Command command) {
    var _ = controller.submit(command);
    return this;
  }

  /** Runs until the program has ended, and a little longer. */
  PlayedRun toEnd() {
    for (int i = 0; i < 20_000 && controller.state().program().ending().isEmpty(); i++) {
      frames(1);
    }
    return frames(10);
  }

  ControllerState state() {
    return controller.state();
  }

  OperatedRun facts() {
    return RunReader.read(ring.recording(), Optional.of(journal.after(0))).orElseThrow();
  }

  /** What is known where nobody has noted the commands. */
  OperatedRun factsOfFile() {
    return RunReader.read(ring.recording(), Optional.empty()).orElseThrow();
  }

  Optional<OperatedRun> any() {
    return RunReader.read(ring.recording(), Optional.of(journal.after(0)));
  }

  /** What comes of a test of the program. */
  TestResult run(String test) {
    TestRunner runner =
        new TestRunner(
            name -> {
              if (name.equals(PROGRAM)) {
                return text.getBytes(StandardCharsets.ISO_8859_1);
              }
              if (name.equals("pick_test.script")) {
                return test.getBytes(StandardCharsets.UTF_8);
              }
              throw new IOException("is not there");
            },
            new TestSettings(
                ControllerOptions.headless(), 1, 1, 300, Duration.ofSeconds(60), false),
            each -> true,
            each -> {},
            Goldens.NONE,
            Optional.empty());
    SuiteResult result = runner.run(runner.plan(List.of("pick_test.script")));
    if (!result.broken().isEmpty()) {
      throw new AssertionError(result.broken().getFirst().problems() + "\n" + test);
    }
    return result.results().getFirst();
  }
}
