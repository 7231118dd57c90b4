package org.pendant.hostile;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Small programs that ask for as much computing time or memory as they can. */
final class HostilePrograms {
  private static final String LISTS =
      """
      a = make_list(1000000, 0, 1000000)
      c = make_list(1000000, 0, 1000000)
      """;

  private static final String MATRIX =
      """
      z = make_list(60, 0.5, 60)
      m = [z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, \
      z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z, z]
      i = 0
      while i < 60:
        m[i, i] = 3.5 + i
        i = i + 1
      end
      """;

  private HostilePrograms() {}

  /** The programs by name. */
  static Map<String, String> all() {
    Map<String, String> programs = new LinkedHashMap<>();
    endless(programs, "empty-loop", "", "");
    endless(programs, "assign-list", LISTS, "b = a");
    endless(programs, "compare-lists", LISTS, "x = (a == c)");
    endless(programs, "pass-list", "def f(l):\n  return 1\nend\n" + LISTS, "x = f(a)");
    endless(
        programs, "change-copy", "def f(l):\n  l[1] = 1\n  return 1\nend\n" + LISTS, "x = f(a)");
    endless(programs, "print-list", LISTS, "textmsg(a)");
    endless(programs, "text-of-list", LISTS, "s = a.to_string()");
    endless(programs, "literal-of-lists", LISTS, "b = [a, a, a, a]");
    endless(programs, "make-list", "", "b = make_list(1000000, 0, 1000000)");
    endless(programs, "make-list-of-texts", "", "b = make_list(1000000, \"x\", 1000000)");
    endless(programs, "add-lists", LISTS, "b = a + c");
    endless(programs, "insert", LISTS + "a.pop()\n", "a.insert(0, 1)\na.remove(0)");
    endless(programs, "slice", LISTS, "b = a.slice(0, 999999)");
    endless(programs, "grow-list", "b = make_list(0, 0, 1000000)\n", "b.append(1)");
    endless(
        programs,
        "grow-list-of-lists",
        LISTS + "s = struct(l=a)\nb = make_list(0, s, 100000)\n",
        "b.append(s)\nb[0].l[1] = b[0].l[1] + 1");
    endless(programs, "multiply-matrices", MATRIX, "x = m * m");
    endless(programs, "invert-matrix", MATRIX, "x = inv(m)");
    endless(programs, "transpose-matrix", MATRIX, "x = transpose(m)");
    endless(programs, "print-matrix", MATRIX, "textmsg(m)");
    endless(programs, "copy-matrix", MATRIX, "x = m\nx[1, 1] = 2.0\nk = m.get_row(1)");
    programs.put("nest-structs", nest());
    endless(
        programs,
        "inverse-kinematics",
        "p = p[-0.4, -0.2, 0.3, 0, 3.14, 0]\n",
        "x = get_inverse_kin(p)");
    endless(programs, "no-solution", "", "x = get_inverse_kin_has_solution(p[2, 2, 2, 0, 0, 0])");
    endless(programs, "forward-kinematics", "", "x = get_forward_kin()");
    endless(
        programs,
        "poses",
        "p = p[0.1, 0.2, 0.3, 0.4, 0.5, 0.6]\n",
        "p = pose_trans(p, pose_inv(interpolate_pose(p, p, 0.3)))");
    endless(programs, "popup", "", "popup(\"x\")");
    endless(programs, "popup-list", LISTS, "popup(a)");
    endless(
        programs,
        "double-string",
        "s = \"ab\"\n",
        "s = s + s\nif length(s) > 500000:\ns = \"ab\"\nend");
    endless(
        programs,
        "search-string",
        "s = \"aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa\"\nwhile length(s) < 500000:\ns = s + s\nend\n",
        "x = str_find(s, \"aaaaaaaaaaaaaaaaaaaab\")");
    endless(programs, "numbers-to-text", "", "s = str_cat(to_str(0.1), to_str(p[1,2,3,4,5,6]))");
    endless(
        programs,
        "deep-recursion",
        "def f(n):\n  if n == 0:\n    return 0\n  end\n  return f(n - 1)\nend\n",
        "x = f(900)");
    endless(programs, "run-and-join", "thread t():\n  x = 1\nend\n", "h = run t()\njoin h");
    endless(programs, "run-and-kill", "thread t():\n  x = 1\nend\n", "h = run t()\nkill h");
    programs.put("threads-that-start-threads", chain());
    programs.put("spinning-threads", spinning(46));
    endless(
        programs,
        "dynamics",
        "",
        "x = get_joint_torques()\ny = get_tcp_force()\nz = get_actual_tcp_pose()");
    endless(programs, "random-numbers", "", "x = random() + sin(0.3) + norm([1, 2, 3])");
    return programs;
  }

  private static void endless(
      Map<String, String> programs, String name, String before, String body) {
    programs.put(
        name, program(before + "while True:\n" + body.indent(2).stripTrailing() + "\nend\n"));
  }

  /** Statements beside a thread that counts the frames in which it had its turn. */
  private static String program(String statements) {
    return "def hostile():\n"
        + "  global beats = 0\n"
        + "  thread heart():\n"
        + "    while True:\n"
        + "      beats = beats + 1\n"
        + "      sync()\n"
        + "    end\n"
        + "  end\n"
        + "  run heart()\n"
        + statements.indent(2)
        + "end\n";
  }

  /** Each turn makes a struct with twice as many members in it. */
  private static String nest() {
    StringBuilder text = new StringBuilder("s0 = struct(a=1, b=2)\n");
    for (int i = 1; i < 40; i++) {
      text.append("s%d = struct(a=s%d, b=s%d)\n".formatted(i, i - 1, i - 1));
    }
    return program("while True:\n" + text.toString().indent(2) + "end\n");
  }

  private static String chain() {
    StringBuilder text = new StringBuilder();
    text.append("thread last():\n  x = 1\nend\n");
    for (String name : List.of("third", "second", "first")) {
      String next = name.equals("third") ? "last" : name.equals("second") ? "third" : "second";
      text.append("thread %s():\n  h = run %s()\n  join h\nend\n".formatted(name, next));
    }
    text.append("while True:\n  h = run first()\n  join h\nend\n");
    return program(text.toString());
  }

  private static String spinning(int count) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < count; i++) {
      text.append(
          "thread t%d():\n  while True:\n    x = 1\n  end\nend\nrun t%d()\n".formatted(i, i));
    }
    return program(text + "while True:\n  y = 1\nend\n");
  }
}
