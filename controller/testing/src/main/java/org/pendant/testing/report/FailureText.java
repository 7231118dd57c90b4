package org.pendant.testing.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.testing.TestFailure;
import org.pendant.testing.TestPlace;
import org.pendant.testing.TestResult;

/**
 * Failure text: why a test is red, in the form in which {@code pendant check} and {@code run} tell
 * errors: {@code file:line:column: error: message}, the source line, a caret, the call stack.
 */
final class FailureText {
  /** What stands before further lines of a message: no tool may take them for lines of ours. */
  static final String QUOTED = "  | ";

  /** Of a deeper call stack (endless recursion) only the ends are shown. */
  private static final int MAX_CALLS = 20;

  private static final int INNERMOST_CALLS = 10;

  private FailureText() {}

  /** Lines without line ends, without the output of the test. */
  static List<String> lines(TestResult result, SourceExcerpts excerpts, ReportLanguage language) {
    Optional<TestPlace> place = result.failure().flatMap(TestFailure::place);
    List<String> message = language.shown(ReportText.message(result));
    List<String> lines = new ArrayList<>();
    lines.add(language.text("errorAt", text(place.orElse(result.place())), message.getFirst()));
    message.stream().skip(1).map(each -> QUOTED + each).forEach(lines::add);
    place.ifPresent(each -> lines.addAll(excerpts.of(each)));
    calls(result, language).forEach(each -> lines.add("  " + each));
    return lines;
  }

  /**
   * The call stack, innermost first: {@code in grip, pick.script:12:3}. Empty where the fault is in
   * the test itself, which its place says.
   */
  static List<String> calls(TestResult result, ReportLanguage language) {
    List<TestPlace> stack = new ArrayList<>();
    result.failure().flatMap(TestFailure::place).ifPresent(stack::add);
    result.failure().ifPresent(each -> stack.addAll(each.stack()));
    if (stack.size() == 1 && ownFunction(stack.getFirst(), result)) {
      return List.of();
    }
    List<String> calls = new ArrayList<>();
    for (int i = 0; i < stack.size(); i++) {
      if (stack.size() > MAX_CALLS && i == INNERMOST_CALLS) {
        int left = stack.size() - MAX_CALLS;
        calls.add(language.text("moreCalls", left));
        i += left;
      }
      TestPlace call = stack.get(i);
      calls.add(
          call.function().isEmpty()
              ? language.text("calledAt", text(call))
              : language.text("calledIn", ReportText.line(call.function()), text(call)));
    }
    return calls;
  }

  private static boolean ownFunction(TestPlace place, TestResult result) {
    return place.function().isEmpty() || place.function().equals(result.id().function());
  }

  /** Such as {@code pick_test.script:12:3}. */
  static String text(TestPlace place) {
    return ReportText.line(place.text());
  }
}
