package org.pendant.testing.mutation;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.language.source.Source;

class MutationFinderTest {
  /** Each as its kind, and what becomes of the line. */
  private static List<String> found(String... lines) {
    Source source = Source.of("pick.script", String.join("\n", lines) + "\n");
    return MutationFinder.in(source, StandardBuiltins.create()).stream()
        .map(each -> each.kind().text() + ": " + each.after(source))
        .toList();
  }

  @Test
  void comparisonsMoveTheirLimitOrBecomeTheirOpposite() {
    assertEquals(
        List.of("comparison: x = n <= m", "comparison: y = n < m", "comparison: z = n != m"),
        found("x = n < m", "y = n <= m", "z = n == m"));
  }

  @Test
  void conditionsAreTurnedRoundUnlessAComparisonDoesThat() {
    assertEquals(
        List.of(
            "condition: if not (ready):",
            "condition: elif done:",
            "comparison: elif n != m:",
            "condition: while not (full()):"),
        found(
            "if ready:",
            "  halt",
            "elif not done:",
            "  halt",
            "elif n == m:",
            "  halt",
            "end",
            "while full():",
            "  halt",
            "end"));
  }

  @Test
  void wordsBetweenTruthsAreSwapped() {
    assertEquals(
        List.of("logic: x = (a) and (b)", "logic: y = a or b"),
        found("x = (a) or (b)", "y = a and b"));
  }

  @Test
  void arithmeticIsSwapped() {
    assertEquals(
        List.of(
            "arithmetic: x = a - b",
            "arithmetic: x = a + b",
            "arithmetic: x = (a / b)",
            "arithmetic: x = a * b",
            "arithmetic: x = a * b"),
        found("x = a + b", "x = a - b", "x = (a * b)", "x = a / b", "x = a % b"));
  }

  @Test
  void numbersBecomeLargerAndTruthsTheirOpposite() {
    assertEquals(
        List.of(
            "constant: x = 4",
            "constant: x = 0.0055",
            "constant: x = 1.0",
            "constant: x = 11.0",
            "constant: x = 2.2E12",
            "constant: x = False"),
        found("x = 3", "x = 0.005", "x = 0.0", "x = 1e1", "x = 2e12", "x = True"));
  }

  @Test
  void movesAreLeftOutAndTheirSpeedsDoubled() {
    assertEquals(
        List.of(
            "move dropped: ",
            "speed: movel(place, a=2.4, v=0.25)",
            "speed: movel(place, a=1.2, v=0.5)",
            "move dropped: ",
            "speed: movej(place, 2 * a, limit)",
            "speed: movej(place, a, 2 * limit)"),
        found("movel(place, a=1.2, v=0.25)", "movej(place, a, limit)"));
  }

  @Test
  void timesThatAreNothingStayNothing() {
    assertEquals(
        List.of("move dropped: ", "speed: movel(place, t=0, r=0.04)"),
        found("movel(place, t=0, r=0.02)"));
  }

  @Test
  void callsAreLeftOutWhereTheyDoSomething() {
    assertEquals(
        List.of("call dropped: ", "call dropped: ", "speed: sleep(1.0)"),
        found("grip()", "sleep(0.5)", "textmsg(\"x\")", "sync()", "norm(x)", "def grip():", "end"));
  }

  @Test
  void outputsAndInputsBecomeTheirNeighboursAndLevelsTheirOpposite() {
    assertEquals(
        List.of(
            "call dropped: ",
            "I/O swapped: set_standard_digital_out(1, True)",
            "I/O swapped: set_standard_digital_out(0, False)",
            "I/O swapped: x = get_standard_digital_in(6)",
            "I/O swapped: y = get_tool_analog_in(0)"),
        found(
            "set_standard_digital_out(0, True)",
            "x = get_standard_digital_in(7)",
            "y = get_tool_analog_in(1)"));
  }

  @Test
  void payloadsAreDoubled() {
    assertEquals(
        List.of("call dropped: ", "payload: set_payload_mass(2.4)"),
        found("set_payload_mass(1.2)"));
  }

  @Test
  void functionsAnswerSomethingElse() {
    assertEquals(
        List.of(
            "return value: return p[0, 0, 0, 0, 0, 0]",
            "return value: return not (get_flag(n))",
            "return value: return 0",
            "return value: return found"),
        found(
            "def f(x, n):",
            "  return pose_trans(x, x)",
            "  return get_flag(n)",
            "  return floor(n)",
            "  return not found",
            "end"));
  }

  @Test
  void textsWithErrorsAreNotMutated() {
    assertEquals(List.of(), found("x = (1 +", "y = 3"));
  }
}
