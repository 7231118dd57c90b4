package org.pendant.fuzz;

import java.util.ArrayList;
import java.util.List;
import java.util.random.RandomGenerator;

/** Tokens in an order that the grammar of URScript allows, of every rule that it has. */
final class GrammarText {
  private static final List<String> NAMES =
      List.of("a", "b", "c", "f", "g", "p", "x1", "_t", "endless", "iffy", "movej", "textmsg");
  private static final List<String> LITERALS =
      List.of("0", "1", "2147483648", "1.5", ".3", "4.", "5e-3", "1e999", "True", "False", "None");
  private static final List<String> STRINGS =
      List.of("\"\"", "\"text\"", "\"a\\\\ # $ (' end\"", "\"\u00e9\"");
  private static final List<String> BINARY =
      List.of("or", "xor", "and", "==", "!=", "<", ">", "<=", ">=", "+", "-", "*", "/", "%");
  private static final List<String> PREFIXES = List.of("not", "!", "-", "+");
  private static final List<String> ENDS_OF_LINE =
      List.of("break", "continue", "halt", "pause", "enter_critical", "exit_critical");

  private final RandomGenerator random;
  private final List<String> tokens = new ArrayList<>();

  GrammarText(RandomGenerator random) {
    this.random = random;
  }

  /** Some statements, nested up to {@code depth} deep. {@code "\n"} is a line end that must be. */
  List<String> statements(int depth) {
    block(depth);
    return tokens;
  }

  private void block(int depth) {
    for (int i = random.nextInt(4); i >= 0; i--) {
      statement(depth);
      put("\n");
    }
  }

  private void statement(int depth) {
    switch (random.nextInt(depth > 0 ? 16 : 9)) {
      case 0, 1 -> effect();
      case 2 -> {
        put(random.nextBoolean() ? "global" : "local", name(), "=");
        expression(2);
      }
      case 3 -> {
        put("return");
        if (random.nextBoolean()) {
          expression(2);
        }
      }
      case 4 -> put(oneOf(ENDS_OF_LINE));
      case 5 -> {
        put(random.nextBoolean() ? "join" : "kill");
        expression(1);
      }
      case 6 -> put("$ 1 \"label\" \"noBreak\"");
      case 7, 8 -> {
        put(name(), "=");
        expression(3);
      }
      case 9, 10, 11 -> conditional(depth);
      case 12, 13 -> {
        put("while");
        expression(2);
        put(":");
        block(depth - 1);
        put("end");
      }
      default -> definition(depth);
    }
  }

  private void effect() {
    if (random.nextInt(6) == 0) {
      put("run", name());
      arguments(1);
    } else {
      put(name());
      arguments(2);
      suffixes(1);
    }
    if (random.nextInt(4) == 0) {
      put("=");
      expression(2);
    }
  }

  private void conditional(int depth) {
    put("if");
    expression(2);
    put(":");
    block(depth - 1);
    for (int i = random.nextInt(3); i > 0; i--) {
      put("elif");
      expression(2);
      put(":");
      block(depth - 1);
    }
    if (random.nextBoolean()) {
      put("else", ":");
      block(depth - 1);
    }
    put("end");
  }

  private void definition(int depth) {
    put(oneOf(List.of("def", "def", "sec", "thread")), name(), "(");
    for (int i = random.nextInt(3); i > 0; i--) {
      put(name());
      if (random.nextBoolean()) {
        put("=");
        expression(1);
      }
      if (i > 1) {
        put(",");
      }
    }
    put(")", ":");
    block(depth - 1);
    put("end");
  }

  private void expression(int depth) {
    operand(depth);
    for (int i = random.nextInt(3); i > 0 && depth > 0; i--) {
      put(oneOf(BINARY));
      operand(depth - 1);
    }
  }

  private void operand(int depth) {
    for (int i = random.nextInt(6); i > 4; i--) {
      put(oneOf(PREFIXES));
    }
    switch (random.nextInt(depth > 0 ? 9 : 4)) {
      case 0, 1 -> put(oneOf(LITERALS));
      case 2 -> put(oneOf(STRINGS));
      case 3 -> put(name());
      case 4 -> {
        put("(");
        expression(depth - 1);
        put(")");
      }
      case 5 -> {
        put(random.nextBoolean() ? "p[" : "[");
        list(depth - 1);
        put("]");
      }
      case 6 -> {
        put("run", name());
        arguments(depth - 1);
      }
      default -> {
        put(name());
        arguments(depth - 1);
        suffixes(depth - 1);
      }
    }
  }

  private void suffixes(int depth) {
    for (int i = random.nextInt(4); i > 2; i--) {
      if (random.nextBoolean()) {
        put(".", name());
        arguments(depth);
      } else {
        put("[");
        list(Math.max(0, depth));
        put("]");
      }
    }
  }

  private void arguments(int depth) {
    put("(");
    if (random.nextInt(4) == 0) {
      put(name(), "=");
    }
    list(Math.max(0, depth));
    put(")");
  }

  private void list(int depth) {
    int size = random.nextInt(4) == 0 ? 6 : random.nextInt(3);
    for (int i = 0; i < size; i++) {
      if (i > 0) {
        put(",");
      }
      expression(depth);
    }
  }

  private String name() {
    return oneOf(NAMES);
  }

  private void put(String... more) {
    tokens.addAll(List.of(more));
  }

  private <T> T oneOf(List<T> choices) {
    return choices.get(random.nextInt(choices.size()));
  }
}
