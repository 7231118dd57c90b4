package org.pendant.testing.run;

import static org.pendant.testing.run.TestRunTexts.text;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.bench.TestBench;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.ProgramState;
import org.pendant.script.vm.ScriptFailure;
import org.pendant.script.vm.ScriptFailure.StackEntry;
import org.pendant.testing.builtin.AssertionCodes;
import org.pendant.testing.remote.TargetView;
import org.pendant.testing.run.TestPlan.Chosen;
import org.pendant.testing.source.SentAssertions;
import org.pendant.testing.source.SentTest;

/** Sent run: a test that a target runs by itself, and what it tells of itself by the log. */
final class SentRun {
  private final Chosen one;
  private final TestBench bench;
  private final String mark = "pendant-" + Long.toHexString(System.nanoTime());
  private final SentTest test;
  private Optional<Ending> told = Optional.empty();

  SentRun(Chosen one, TestBench bench) {
    this.one = one;
    this.bench = bench;
    test =
        one.file().sent().of(one.test(), one.file().calls().get(one.test().id().function()), mark);
  }

  /** What is sent. */
  SentTest test() {
    return test;
  }

  /** Takes a line of the log; answers whether it is for nobody else. */
  boolean takes(String line) {
    if (!line.startsWith(mark + " ")) {
      return false;
    }
    String[] words = line.split(" ", 4);
    String text = words.length > 3 ? words[3] : "";
    switch (words.length > 1 ? words[1] : "") {
      case SentAssertions.DONE -> told = Optional.of(new Ending.Finished());
      case SentAssertions.FAILED -> told = failed(AssertionCodes.FAILED, text, words[2]);
      case SentAssertions.SKIPPED -> told = failed(AssertionCodes.SKIPPED, text, words[2]);
      case SentAssertions.EXPECTS -> bench.expected().failure(text);
      default -> {}
    }
    return true;
  }

  private Optional<Ending> failed(String code, String text, String number) {
    int line;
    try {
      line = Integer.parseInt(number);
    } catch (NumberFormatException _) {
      line = 0;
    }
    return Optional.of(failed(code, text, line));
  }

  private Ending failed(String code, String text, int line) {
    Source source = one.file().sent().source();
    int at = Math.clamp(line, 1, source.lineCount());
    String whole = source.lineText(at);
    int start = source.lineStart(at) + whole.length() - whole.stripLeading().length();
    return new Ending.Failed(
        new ScriptFailure(
            code,
            text,
            new SourceRange(start, start),
            at,
            source.column(start),
            List.of(new StackEntry("", at))));
  }

  /** How it ended; empty while it runs. */
  Optional<Ending> ending(TargetProgram program, TargetView view) {
    if (view.stopped() && program.state() == ProgramState.PAUSED) {
      // nobody is there to end the stop
      return Optional.of(new Ending.Finished());
    }
    Optional<Ending> ending = program.ending();
    if (ending.isEmpty() || ending.get() instanceof Ending.Failed) {
      return ending;
    }
    return told.isPresent()
        ? told
        : Optional.of(failed("halted", text("stoppedAtTarget"), one.test().place().line()));
  }
}
