package org.pendant.fuzz;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.SplittableRandom;
import org.pendant.language.signature.Parameter;
import org.pendant.language.signature.Signature;
import org.pendant.language.signature.Type;
import org.pendant.script.function.Builtins;

/**
 * A program that compiles: functions, a thread, loops and calls of every built-in function, with
 * values of the right kind that are often out of every range.
 */
final class RandomProgram {
  /** They would wait for people or the network, which a run of some frames has none of. */
  private static final Set<String> LEFT_OUT = Set.of("interpreter_mode");

  private static final List<String> NUMBERS =
      List.of(
          "0",
          "1",
          "-1",
          "2",
          "6",
          "0.5",
          "-0.25",
          "1e-300",
          "1e300",
          "-1e9",
          "2147483647",
          "-2147483648",
          "inf",
          "-inf",
          "nan",
          "n",
          "l[1]");

  private static final List<String> STRINGS =
      List.of("\"\"", "\"x\"", "\"12.5\"", "\"[1,2]\"", "\"\u00e9\u0001\"", "s", "\"127.0.0.1\"");

  private final SplittableRandom random;
  private final List<Signature> functions;
  private final StringBuilder text = new StringBuilder();

  RandomProgram(SplittableRandom random, Builtins<?> builtins) {
    this.random = random;
    functions =
        builtins.all().stream()
            .filter(each -> each.receiver().isEmpty() && !LEFT_OUT.contains(each.name()))
            .toList();
  }

  String text() {
    text.append(
        """
        def fuzzed():
          global inf = 1e999
          global nan = inf - inf
          global n = 3
          global s = "text"
          global l = [1, 2.5, 3]
          global m = [[1, 2], [3, 4]]
          global o = struct(a = 1, b = "two")
          def any(of):
            return of
          end
          thread t():
        """);
    block(1);
    text.append("    sync()\n  end\n  def f(n, s):\n");
    block(1);
    text.append("    return ").append(value(Type.ANY, 2)).append("\n  end\n");
    text.append("  local handle = run t()\n");
    block(3);
    text.append("  f(").append(value(Type.NUMBER, 1)).append(", s)\n");
    block(2);
    text.append("end\n");
    return text.toString();
  }

  private void block(int depth) {
    for (int i = random.nextInt(4); i >= 0; i--) {
      statement(depth);
    }
  }

  private void statement(int depth) {
    switch (random.nextInt(depth > 0 ? 9 : 6)) {
      case 0, 1, 2, 3 -> line(call(oneOf(functions), 2));
      case 4 ->
          line(
              oneOf(List.of("n", "s", "l[1]", "m[0,1]", "o.a"))
                  + " = any("
                  + value(Type.ANY, 2)
                  + ")");
      case 5 -> line("textmsg(" + value(Type.ANY, 2) + ", " + value(Type.ANY, 2) + ")");
      case 6 -> {
        line("if any(" + value(Type.BOOL, 2) + "):");
        block(depth - 1);
        line("else:");
        block(depth - 1);
        line("end");
      }
      case 7 -> {
        line("while any(" + value(Type.BOOL, 1) + "):");
        block(depth - 1);
        line(random.nextBoolean() ? "break" : "sync()");
        line("end");
      }
      default -> line("local v = any(" + value(Type.ANY, 3) + ")");
    }
  }

  /** Required arguments always, the others by chance; sometimes by name. */
  private String call(Signature function, int depth) {
    StringBuilder call = new StringBuilder(function.name()).append('(');
    String separator = "";
    boolean named = false;
    for (Parameter parameter : function.parameters()) {
      if (!parameter.required() && random.nextBoolean()) {
        named = true;
        continue;
      }
      call.append(separator);
      if (named) {
        call.append(parameter.name()).append('=');
      }
      call.append(argument(parameter.type(), depth - 1));
      separator = ", ";
    }
    return call.append(')').toString();
  }

  /** The checker cannot know what {@code any} returns: here values may be of a wrong kind. */
  private String argument(Type type, int depth) {
    return random.nextInt(12) == 0
        ? "any(" + value(Type.ANY, depth) + ")"
        : "any(" + value(type, depth) + ")";
  }

  private String value(Type type, int depth) {
    Optional<Signature> giver =
        depth > 0 && random.nextInt(4) == 0
            ? functions.stream()
                .filter(each -> each.result() == type)
                .skip(random.nextInt(5))
                .findFirst()
            : Optional.empty();
    if (giver.isPresent()) {
      return "any(" + call(giver.get(), depth - 1) + ")";
    }
    return switch (type) {
      case ANY -> {
        Type chosen = oneOf(List.of(Type.values()));
        yield value(chosen == Type.ANY ? Type.NUMBER : chosen, depth - 1);
      }
      case NONE, RPC_HANDLE, EIP_HANDLE -> "None";
      case BOOL -> random.nextBoolean() ? "True" : "(any(n) < " + oneOf(NUMBERS) + ")";
      case INT -> random.nextInt(5) == 0 ? oneOf(NUMBERS) : String.valueOf(random.nextInt(-2, 20));
      case NUMBER -> number(depth);
      case STRING -> oneOf(STRINGS);
      case POSE -> "p" + list(6);
      case LIST -> random.nextInt(3) == 0 ? "l" : list(1 + random.nextInt(8));
      case JOINTS -> list(6);
      case POSE_OR_JOINTS -> (random.nextBoolean() ? "p" : "") + list(6);
      case MATRIX -> random.nextBoolean() ? "m" : "[" + list(2) + ", " + list(2) + "]";
      case STRUCT -> random.nextBoolean() ? "o" : "struct(x = " + oneOf(NUMBERS) + ")";
    };
  }

  private String number(int depth) {
    if (depth <= 0 || random.nextInt(3) > 0) {
      return oneOf(NUMBERS);
    }
    return "(any("
        + number(depth - 1)
        + ") "
        + oneOf(List.of("+", "-", "*", "/", "%"))
        + " any("
        + number(depth - 1)
        + "))";
  }

  private String list(int size) {
    StringBuilder list = new StringBuilder("[");
    for (int i = 0; i < size; i++) {
      boolean wild = random.nextInt(8) == 0;
      list.append(i > 0 ? ", " : "")
          .append(
              wild
                  ? "any(" + oneOf(NUMBERS) + ")"
                  : String.valueOf(random.nextInt(-30, 30) / 10.0));
    }
    return list.append(']').toString();
  }

  private void line(String statement) {
    text.append("    ").append(statement).append('\n');
  }

  private <T> T oneOf(List<T> choices) {
    return choices.get(random.nextInt(choices.size()));
  }
}
