package org.pendant.language.parse;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.SplittableRandom;
import org.pendant.language.source.Source;

/** Random edits: a text as it is typed in, pasted into and cut, right and wrong. */
public final class RandomEdits {
  private static final List<String> PIECES =
      List.of(
          "a",
          "mov",
          "ej",
          "1",
          ".",
          "(",
          ")",
          "[",
          "]",
          "=",
          ":",
          ",",
          "\"",
          "'",
          "#",
          ";",
          "\n",
          "\r\n",
          "  ",
          "-",
          "not ",
          "\u00e9",
          "\u0001",
          "end\n",
          "end",
          "\nend\n",
          "if a:\n",
          "else:\n",
          "elif b:\n",
          "else if c:\n",
          "while True:\n",
          "def f(x):\n",
          "def g():\n  a = 1\nend\n",
          "thread t():\n",
          "sec s():\n",
          "return",
          "return\n",
          "$ 1 \"x\"\n",
          "global b = 1\n",
          "local c = [1, 2]\n",
          "x = = 1\n",
          "foo(1,\n",
          "  2)\n",
          "foo(a=1)\n",
          "// x\n",
          "i += 1\n",
          "for i in x:\n",
          "endif\n",
          "{{ x }}",
          "p[1, 2]\n",
          "1 + 2\n",
          "\"open\n",
          "run t()\n",
          "break\n",
          "-1\n",
          "(a)\n",
          ".end",
          "{% if x %}",
          "a.b = 2\n",
          "x()\ny()\n",
          "&&",
          "+\n");

  private final SplittableRandom random;

  public RandomEdits(SplittableRandom random) {
    this.random = random;
  }

  /** A program of a few functions, called {@code name}. */
  public Source program(String name) {
    StringBuilder text = new StringBuilder(random.nextInt(8) == 0 ? "\u00EF\u00BB\u00BF" : "");
    RandomTrees trees = new RandomTrees(random);
    for (int i = random.nextInt(4); i >= 0; i--) {
      String body = new ScriptPrinter(random).print(trees.statements(2));
      text.append(random.nextInt(3) == 0 ? body : "def f" + i + "():\n" + body + "\nend\n");
    }
    return source(name, text.toString());
  }

  /** The text after one edit, mostly a small one. */
  public Source edited(Source before) {
    String text = before.text();
    int from = random.nextInt(text.length() + 1);
    int to = from;
    if (random.nextInt(3) == 0) {
      int most = random.nextInt(5) == 0 ? 200 : 6;
      to = Math.min(text.length(), from + random.nextInt(most));
    }
    String inserted = random.nextInt(3) == 0 && to > from ? "" : piece(text);
    return source(before.name(), text.substring(0, from) + inserted + text.substring(to));
  }

  private String piece(String text) {
    if (random.nextInt(10) == 0 && !text.isEmpty()) {
      int from = random.nextInt(text.length());
      return text.substring(from, Math.min(text.length(), from + random.nextInt(80)));
    }
    return PIECES.get(random.nextInt(PIECES.size()));
  }

  private static Source source(String name, String bytes) {
    return Source.of(name, bytes.getBytes(StandardCharsets.ISO_8859_1));
  }
}
