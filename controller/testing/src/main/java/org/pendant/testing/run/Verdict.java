package org.pendant.testing.run;

import static org.pendant.testing.run.TestRunTexts.text;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.pendant.controller.bench.Expected;
import org.pendant.controller.bench.TestBench;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.ByteText;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.ScriptFailure;
import org.pendant.testing.TestFailure;
import org.pendant.testing.TestPlace;
import org.pendant.testing.TestStatus;
import org.pendant.testing.builtin.AssertionCodes;
import org.pendant.testing.source.TestCase;
import org.pendant.testing.source.TestFile;

/** Verdict on a test: what its end, and that of the program it has started, mean. */
final class Verdict {
  private final TestFile file;
  private final TestCase test;
  private final TestPrograms programs;
  private final TestBench bench;

  Verdict(TestFile file, TestCase test, TestPrograms programs, TestBench bench) {
    this.file = file;
    this.test = test;
    this.programs = programs;
    this.bench = bench;
  }

  /** The verdict on a test that has ended. */
  TestOutcome of(Ending ending, ControllerState state) {
    return switch (ending) {
      case Ending.Failed(var why) -> failed(why);
      case Ending.Finished _, Ending.Halted _ -> ended(state);
      case Ending.Stopped _ -> stopped(state);
    };
  }

  private TestOutcome failed(ScriptFailure why) {
    if (why.code().equals(AssertionCodes.SKIPPED) || why.code().equals(AssertionCodes.DROPPED)) {
      return TestOutcome.skipped(ByteText.decoded(why.message()));
    }
    Optional<String> wanted = bench.expected().failure();
    if (wanted.isPresent() && why.message().contains(wanted.get())) {
      return TestOutcome.PASSED;
    }
    boolean expectation = why.code().equals(AssertionCodes.FAILED) || wanted.isPresent();
    String message = ByteText.decoded(why.message());
    return TestOutcome.red(
        expectation ? TestStatus.FAILED : TestStatus.ERROR,
        new TestFailure(
            why.code(),
            wanted
                .map(part -> text("otherFailureWanted", message, ByteText.decoded(part)))
                .orElse(message),
            Optional.of(file.composition().place(why.range().start(), functionOf(why))),
            stack(why)));
  }

  private String functionOf(ScriptFailure why) {
    String function = why.stack().isEmpty() ? "" : why.stack().getFirst().function();
    return made(function) ? "" : function;
  }

  /** Whether no text of people has a function of this name. */
  private static boolean made(String function) {
    return function.startsWith("$");
  }

  /** Where the failing function was called from, made lines left out. */
  private List<TestPlace> stack(ScriptFailure why) {
    List<TestPlace> places = new ArrayList<>();
    for (ScriptFailure.StackEntry each : why.stack().stream().skip(1).toList()) {
      TestPlace place = file.composition().placeOfLine(each.line(), each.function());
      if (place.column() == 0 && !made(each.function())) {
        places.add(place);
      }
    }
    return places;
  }

  private TestOutcome ended(ControllerState state) {
    Expected expected = bench.expected();
    if (expected.failure().isPresent()) {
      return red(
          AssertionCodes.FAILED, text("failureWanted", ByteText.decoded(expected.failure().get())));
    }
    Optional<SafetyStop> stop = state.safety().stop();
    if (stop.isPresent() && !expected.knowsSafetyStop()) {
      return stopped(state);
    }
    if (!expected.knowsProgramFailure()
        && bench.ending().orElse(new Ending.Finished()) instanceof Ending.Failed(var why)) {
      return ofProgram(why);
    }
    return unknownMock();
  }

  /** The program under test failed, and the test did not ask how it ended. */
  private TestOutcome ofProgram(ScriptFailure why) {
    String source = bench.programName();
    return TestOutcome.red(
        TestStatus.ERROR,
        new TestFailure(
            why.code(),
            programs.nodeAt(source, why.line()).map(node -> node + ": ").orElse("")
                + text("programFailed", ByteText.decoded(why.message())),
            Optional.of(new TestPlace(source, why.line(), why.column(), functionOf(why))),
            why.stack().stream()
                .skip(1)
                .map(each -> new TestPlace(source, each.line(), 0, each.function()))
                .toList()));
  }

  /** A mock that replaced nothing says that a test does not test what it seems to. */
  private TestOutcome unknownMock() {
    Set<String> missing = new HashSet<>(bench.mocks().functions());
    missing.removeAll(file.functions());
    missing.removeAll(programs.functions());
    return missing.stream()
        .sorted()
        .findFirst()
        .map(name -> red("unknown-function", text("unknownMock", ByteText.decoded(name))))
        .orElse(TestOutcome.PASSED);
  }

  /** The safety functions have stopped the arm, and the test did not want that. */
  TestOutcome stopped(ControllerState state) {
    String why =
        state
            .safety()
            .stop()
            .map(SafetyStop::message)
            .or(() -> state.arm().fault().map(each -> each.message()))
            .orElse(text("testStopped"));
    int line = test.watches() ? 0 : state.safety().stopPlace().map(each -> each.line()).orElse(0);
    return error("safety-stop", why, line);
  }

  /** The time of a test is up. */
  TestOutcome late(int line, String what) {
    return TestOutcome.red(TestStatus.TIMED_OUT, failure("timed-out", what, line));
  }

  /**
   * Something outside of the test's expectations has ended it.
   *
   * @param line of its program, 0 where no line is known
   */
  TestOutcome error(String code, String message, int line) {
    return TestOutcome.red(TestStatus.ERROR, failure(code, message, line));
  }

  private TestOutcome red(String code, String message) {
    return TestOutcome.red(TestStatus.FAILED, failure(code, message, 0));
  }

  private TestFailure failure(String code, String message, int line) {
    return new TestFailure(
        code,
        ByteText.decoded(message),
        Optional.of(
            line > 0 ? file.composition().placeOfLine(line, test.id().function()) : test.place()),
        List.of());
  }
}
