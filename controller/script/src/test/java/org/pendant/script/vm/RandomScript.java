package org.pendant.script.vm;

import java.util.Random;

/**
 * Makes up programs that end: three functions and a thread that compute with numbers, lists and now
 * and then with something that is neither, and mostly fail sooner or later.
 */
final class RandomScript {
  private static final String[] NAMES = {"a", "b", "m", "n", "g", "h"};
  private static final String[] CONSTANTS = {
    "0", "1", "2", "3", "7", "-1", "0.0", "0.5", "1.0", "2.25", "1000000007", "-3", "1", "2", "3"
  };
  private static final String[] NO_NUMBERS = {"True", "False", "\"s\"", "None", "[1, 2]", "l"};
  private static final String[] OPERATORS = {"+", "-", "*"};
  private static final String[] DIVISIONS = {"/", "%"};
  private static final String[] DIVISORS = {"2", "3", "0.5", "-7", "n", "(m + 1)"};
  private static final String[] COMPARISONS = {"<", "<=", ">", ">=", "==", "!="};

  private final Random random;
  private final StringBuilder text = new StringBuilder();
  private int loops;

  RandomScript(Random random) {
    this.random = random;
  }

  String text() {
    text.append("def prog():\n  global g = 1\n  global h = 2.5\n");
    for (int number = 0; number < 3; number++) {
      text.append("  def f").append(number).append("(a, b):\n");
      text.append("    local l = [1, 2, 3]\n    local m = a\n    local n = 0\n");
      matrix();
      if (random.nextInt(8) == 0) {
        text.append("    local l = [0.5, 1.5, 2.5, 3.5]\n");
      }
      block(number, 4, 4 + random.nextInt(5));
      text.append("    return ").append(expression(number, 2)).append("\n  end\n");
    }
    text.append("  thread t():\n    local a = 1\n    local b = 2\n");
    text.append("    local l = [1.5, 2.5]\n    local m = 3\n    local n = 4\n");
    matrix();
    block(3, 4, 5);
    text.append("  end\n  def body():\n    local a = 5\n    local b = 0.25\n");
    text.append("    local l = [1, 2, 3, 4]\n    local m = 3\n    local n = 4\n");
    matrix();
    text.append("    local k = 0\n    while k < 3:\n      k = k + 1\n");
    if (random.nextInt(3) == 0) {
      text.append("      local handle = run t()\n");
    }
    block(3, 6, 8);
    text.append("      textmsg(").append(expression(3, 2)).append(", g)\n");
    text.append("    end\n  end\n  body()\n  textmsg(h, g)\nend\n");
    return text.toString();
  }

  private void matrix() {
    text.append("    local q = [[1, 2], [").append(pick(CONSTANTS)).append(", 4]]\n");
  }

  private String pick(String[] choices) {
    return choices[random.nextInt(choices.length)];
  }

  private StringBuilder indent(int depth) {
    return text.repeat(' ', depth);
  }

  private void block(int functions, int depth, int statements) {
    for (int i = 0; i < statements; i++) {
      statement(functions, depth);
    }
  }

  private void statement(int functions, int depth) {
    switch (random.nextInt(depth > 10 ? 7 : 10)) {
      case 0, 1, 2 ->
          indent(depth)
              .append(pick(new String[] {"m", "n", "g", "h"}))
              .append(" = ")
              .append(expression(functions, 2))
              .append('\n');
      case 3 ->
          indent(depth).append(random.nextInt(9) == 0 ? "l = [n, m, 1]" : "n = l[1]").append('\n');
      case 4 ->
          indent(depth)
              .append(random.nextInt(3) == 0 ? "q[1, " : "l[")
              .append(random.nextInt(15) == 0 ? expression(functions, 1) : random.nextInt(2))
              .append("] = ")
              .append(random.nextInt(3) == 0 ? expression(functions, 1) : "n")
              .append('\n');
      case 5 -> indent(depth).append("textmsg(").append(expression(functions, 2)).append(", n)\n");
      case 6 -> indent(depth).append(random.nextInt(3) == 0 ? "sync()\n" : "m = m + 1\n");
      case 7, 8 -> {
        indent(depth).append("if ").append(condition(functions, 2)).append(":\n");
        block(functions, depth + 2, 1 + random.nextInt(2));
        if (random.nextBoolean()) {
          indent(depth).append("else:\n");
          block(functions, depth + 2, 1);
        }
        indent(depth).append("end\n");
      }
      default -> loop(functions, depth);
    }
  }

  /** A loop that ends, sometimes only after the budget of a frame. */
  private void loop(int functions, int depth) {
    String counter = "c" + loops++;
    int turns = random.nextInt(12) == 0 ? 60_000 : random.nextInt(5);
    indent(depth).append("local ").append(counter).append(" = 0\n");
    indent(depth).append("while ").append(counter).append(" < ").append(turns).append(":\n");
    indent(depth + 2).append(counter).append(" = ").append(counter).append(" + 1\n");
    if (turns > 10) {
      indent(depth + 2).append("g = ").append(counter).append(" % 5\n");
      indent(depth + 2).append("m = n + l[1] * 0.5\n");
      indent(depth + 2).append("n = q[g % 2, 0] - l[g % 3]\n");
    } else {
      block(functions, depth + 2, 1 + random.nextInt(2));
      if (random.nextInt(4) == 0) {
        indent(depth + 2).append("if ").append(condition(functions, 1)).append(":\n");
        indent(depth + 4).append(random.nextBoolean() ? "break\n" : "continue\n");
        indent(depth + 2).append("end\n");
      }
    }
    indent(depth).append("end\n");
  }

  private String expression(int functions, int depth) {
    if (depth == 0) {
      return random.nextInt(3) == 0 ? pick(CONSTANTS) : pick(NAMES);
    }
    return switch (random.nextInt(12)) {
      case 0, 1 -> "(" + expression(functions, depth - 1) + pick(DIVISIONS) + pick(DIVISORS) + ")";
      case 2, 3, 4, 5 ->
          "("
              + expression(functions, depth - 1)
              + " "
              + pick(OPERATORS)
              + " "
              + expression(functions, depth - 1)
              + ")";
      case 6 -> random.nextInt(3) == 0 ? "q[0, 1]" : "l[" + random.nextInt(2) + "]";
      case 7 -> random.nextInt(9) == 0 ? "l[" + expression(functions, 0) + "]" : "l[1]";
      case 8 ->
          functions > 0
              ? "f"
                  + random.nextInt(functions)
                  + "("
                  + argument(functions, depth - 1)
                  + ", "
                  + argument(functions, 0)
                  + ")"
              : pick(NAMES);
      case 9 -> "-(" + expression(functions, depth - 1) + ")";
      default -> expression(functions, 0);
    };
  }

  /** Only calls let something through whose kind the checker cannot know. */
  private String argument(int functions, int depth) {
    return random.nextInt(15) == 0
        ? random.nextBoolean() ? pick(NO_NUMBERS) : condition(functions, 0)
        : expression(functions, depth);
  }

  private String condition(int functions, int depth) {
    if (depth > 0) {
      switch (random.nextInt(8)) {
        case 0 -> {
          return "(" + condition(functions, depth - 1) + " and " + condition(functions, 0) + ")";
        }
        case 1 -> {
          return "(" + condition(functions, depth - 1) + " or " + condition(functions, 0) + ")";
        }
        case 2 -> {
          return "not " + condition(functions, depth - 1);
        }
        case 3 -> {
          return random.nextBoolean() ? pick(NAMES) : "(" + pick(NAMES) + " xor a)";
        }
        default -> {}
      }
    }
    return "("
        + expression(functions, 1)
        + " "
        + pick(COMPARISONS)
        + " "
        + expression(functions, 0)
        + ")";
  }
}
