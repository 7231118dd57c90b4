package org.pendant.testing.source;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import org.pendant.controller.box.ControlBox;
import org.pendant.language.source.ByteText;
import org.pendant.language.syntax.Expression;
import org.pendant.language.syntax.Expression.Call;
import org.pendant.language.syntax.Statement;
import org.pendant.script.function.Builtin;
import org.pendant.script.function.Builtins;
import org.pendant.script.function.Effect;

/** Reach of tests: what a test may call, itself or by the functions of its file. */
final class TestReach {
  private static final String MOTION = "motion";
  private static final String START = "start";

  private final Builtins<ControlBox> builtins;
  private final Map<String, Set<String>> called = new HashMap<>();
  private final Map<String, Call> moves = new HashMap<>();
  private final Map<String, Set<String>> started = new HashMap<>();

  /**
   * The reach within one file.
   *
   * @param own its statements
   */
  TestReach(List<Statement> own, Builtins<ControlBox> builtins) {
    this.builtins = builtins;
    Definitions.each(
        own,
        definition -> SyntaxWalk.ownOf(definition.body(), each -> note(definition.name(), each)));
    SyntaxWalk.ownOf(own, each -> note("", each));
  }

  private void note(String from, Expression expression) {
    switch (expression) {
      case Call call -> {
        if (call.function().equals(START)
            && !call.arguments().isEmpty()
            && call.arguments().getFirst().value() instanceof Expression.StringLiteral file) {
          started.computeIfAbsent(from, _ -> new TreeSet<>()).add(ByteText.decoded(file.value()));
        }
        called.computeIfAbsent(from, _ -> new LinkedHashSet<>()).add(call.function());
        AnsweringFunction.of(call).ifPresent(each -> called.get(from).add(each.by()));
        if (builtins.find(call.function()).filter(TestReach::moving).isPresent()) {
          moves.putIfAbsent(from, call);
        }
      }
      case Expression.Run run ->
          called.computeIfAbsent(from, _ -> new LinkedHashSet<>()).add(run.thread());
      default -> {}
    }
  }

  private static boolean moving(Builtin<ControlBox> builtin) {
    return builtin.effect() == Effect.MOVES
        || (builtin.signature().physicalTime() && builtin.signature().module().equals(MOTION));
  }

  /** The functions that a test may run, itself and what runs around it included. */
  private Set<String> from(String test) {
    Set<String> seen = new LinkedHashSet<>();
    Deque<String> open = new ArrayDeque<>(List.of(test, "before_each", "after_each", ""));
    while (!open.isEmpty()) {
      String next = open.pop();
      if (seen.add(next)) {
        open.addAll(called.getOrDefault(next, Set.of()));
      }
    }
    return seen;
  }

  /** The functions that a test may run, those that it calls itself first. */
  List<String> all(String test) {
    return List.copyOf(from(test));
  }

  /** Whether a test may start a program. */
  boolean starts(String test) {
    return from(test).contains(START);
  }

  /** The names of the programs that a test may start, where they are written as such. */
  List<String> started(String test) {
    return from(test).stream()
        .flatMap(each -> started.getOrDefault(each, Set.of()).stream())
        .sorted()
        .distinct()
        .toList();
  }

  /** A call by which a test may move the arm itself. */
  Optional<Call> move(String test) {
    return from(test).stream().sorted().filter(moves::containsKey).map(moves::get).findFirst();
  }
}
