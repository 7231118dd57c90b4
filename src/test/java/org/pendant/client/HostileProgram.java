package org.pendant.client;

import java.util.List;

/**
 * A program that takes more than its share, until it is stopped.
 *
 * @param name for people
 * @param text what is uploaded
 */
record HostileProgram(String name, String text) {
  private static final String A_MILLION = "  a = make_list(1000000, 0, 1000000)\n";

  /** One of each kind. */
  static final List<HostileProgram> ALL =
      List.of(
          loop("an empty loop", "", "a = 1"),
          loop("copies a long list", A_MILLION, "b = a"),
          loop("compares long lists", A_MILLION + "  c = a\n", "x = (a == c)"),
          loop("prints a long list", A_MILLION, "textmsg(a)"),
          loop("nests long lists", A_MILLION, "b = [a, a, a, a]"),
          loop("makes long lists", "", "b = make_list(1000000, 0, 1000000)"),
          loop("prints", "  i = 0\n", "i = i + 1\n    textmsg(i)"),
          loop("computes poses", "", "x = get_inverse_kin(p[-0.3, -0.4, 0.4, 0, 3, 0])"),
          loop("opens popups", "", "popup(\"x\")"),
          new HostileProgram(
              "starts threads",
              """
              def hostile():
                thread one():
                  x = 1
                end
                while True:
                  t = run one()
                  join t
                end
              end
              """),
          new HostileProgram(
              "has 40 busy threads",
              "def hostile():\n  thread busy():\n    while True:\n      x = 1\n    end\n  end\n"
                  + "  run busy()\n".repeat(40)
                  + "  while True:\n    sync()\n  end\nend\n"),
          new HostileProgram(
              "recurses",
              """
              def hostile():
                def deep(n):
                  return deep(n + 1)
                end
                deep(0)
              end
              """));

  private static HostileProgram loop(String name, String before, String turn) {
    return new HostileProgram(
        name, "def hostile():\n" + before + "  while True:\n    " + turn + "\n  end\nend\n");
  }
}
