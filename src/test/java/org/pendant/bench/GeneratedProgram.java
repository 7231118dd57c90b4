package org.pendant.bench;

import java.util.Formatter;
import java.util.Locale;
import java.util.Random;

/**
 * A long program such as offline programming tools write: many functions with points, moves, I/O,
 * conditions, loops and arithmetic, with comments and labels between them. The same text each time.
 */
final class GeneratedProgram {
  private static final int SEED = 5;

  private final Random random = new Random(SEED);
  private final StringBuilder text = new StringBuilder();
  private final Formatter out = new Formatter(text, Locale.ROOT);

  private GeneratedProgram() {}

  /** A program of exactly {@code size} bytes without errors. */
  static String ofBytes(int size) {
    return new GeneratedProgram().write(size);
  }

  private String write(int size) {
    text.append("def generated():\n  global count = 0\n  global offsets = [0.0, 0.0, 0.0]\n");
    int functions = 0;
    String end = "\nend\n";
    int mostInFunction = 4_000; // a function with all its statements is shorter
    while (text.length() < size - mostInFunction) {
      writeFunction(functions++);
    }
    // What is missing is filled by a comment, in lines of usual length.
    while (size - text.length() - end.length() > 100) {
      text.append("  # ").append("-".repeat(75)).append('\n');
    }
    text.append('#').append("-".repeat(size - text.length() - 1 - end.length())).append(end);
    return text.toString();
  }

  private void writeFunction(int number) {
    out.format("  # Station %d: approach, work, retreat\n", number);
    out.format(
        "  def station_%d(place, depth=%.3f, repeat=%d):\n", number, unit(), 1 + random.nextInt(5));
    out.format("    local done = 0\n");
    out.format("    local total = 0.0\n");
    out.format("    local steps = [%.4f, %.4f, %.4f, %.4f]\n", unit(), unit(), unit(), unit());
    int statements = 4 + random.nextInt(8);
    for (int i = 0; i < statements; i++) {
      writeStatement(number * 20 + i);
    }
    if (number > 0) {
      out.format("    if done > 1000:\n");
      out.format("      total = total + station_%d(place, repeat=1)\n", random.nextInt(number));
      out.format("    end\n");
    }
    out.format("    return total + done\n");
    out.format("  end\n");
    out.format("\n");
  }

  private void writeStatement(int label) {
    out.format("    $ %d \"Waypoint_%d\"\n", label, label);
    switch (random.nextInt(8)) {
      case 0 -> {
        out.format("    movej(%s, a=1.4, v=%.3f)\n", numbers("["), unit());
        out.format("    sleep(%.2f)\n", unit());
      }
      case 1 -> {
        out.format("    movel(pose_trans(place, %s), a=1.2, v=%.3f)\n", numbers("p["), unit());
        out.format("    set_standard_digital_out(%d, True)\n", random.nextInt(8));
      }
      case 2 -> {
        out.format("    while done < repeat and not (total > %.2f):\n", 100 * unit());
        out.format(
            "      total = total + steps[done %% 4] * (depth - %.4f) / %.3f\n", unit(), unit());
        out.format("      done = done + 1\n");
        out.format("    end\n");
      }
      case 3 -> {
        out.format("    if get_standard_digital_in(%d) == True:\n", random.nextInt(8));
        out.format("      textmsg(\"station reached, total is \", total)\n");
        out.format("    elif total >= %.3f or done == repeat:\n", unit());
        out.format("      offsets[%d] = offsets[%1$d] + %.4f # drift\n", random.nextInt(3), unit());
        out.format("    else:\n");
        out.format("      count = count + 1\n");
        out.format("    end\n");
      }
      case 4 -> {
        out.format("    local target = %s\n", numbers("p["));
        out.format("    target[2] = target[2] + depth * sin(d2r(%.2f))\n", 90 * unit());
        out.format("    total = total + point_dist(place, pose_add(target, %s))\n", numbers("p["));
      }
      case 5 -> {
        out.format("    local part = struct(place = %s, mass = %.3f)\n", numbers("p["), unit());
        out.format(
            "    total = total + part.mass * norm([%.3f, %.3f, %.3f])\n", unit(), unit(), unit());
      }
      case 6 -> {
        out.format("    local name = str_cat(\"part_\", to_str(done))\n");
        out.format("    if str_len(name) > 20:\n");
        out.format("      popup(name, title=\"Name\", warning=True, blocking=False)\n");
        out.format("    end\n");
      }
      default -> {
        out.format("    local grid = [%s, %s]\n", numbers("["), numbers("["));
        out.format(
            "    total = total + grid[1, %d] * -grid[0, %d]\n",
            random.nextInt(6), random.nextInt(6));
      }
    }
  }

  /** Six numbers after an opening bracket. */
  private String numbers(String open) {
    return String.format(
        Locale.ROOT,
        "%s%.4f, %.4f, %.4f, %.4f, %.4f, %.4f]",
        open,
        signed(),
        signed(),
        signed(),
        signed(),
        signed(),
        signed());
  }

  private double unit() {
    return random.nextDouble(0.001, 1);
  }

  private double signed() {
    return random.nextDouble(-1, 1);
  }
}
