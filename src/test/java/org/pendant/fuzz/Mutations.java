package org.pendant.fuzz;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;

/** Spoils a text: tokens dropped, doubled, exchanged or of other languages, stray bytes, cuts. */
final class Mutations {
  /** Of other languages, of a wrong place, or of no language. */
  private static final List<String> FOREIGN =
      List.of(
          "{",
          "}",
          ";",
          ":=",
          "+=",
          "&&",
          "||",
          "<>",
          "//",
          "'x'",
          "'",
          "\"",
          "for",
          "else if",
          "elseif",
          "endif",
          "function",
          "End",
          "DEF",
          "try",
          "case",
          "@",
          "\u00b7",
          "\u0000",
          "\u001b",
          "\u00ff",
          "\r",
          "\f",
          "end",
          "def",
          "if",
          "elif",
          "else",
          "while",
          "thread",
          "sec",
          "(",
          ")",
          "[",
          "]",
          ",",
          ":",
          ".",
          "=",
          "$",
          "#",
          "run",
          "return",
          "global",
          "local",
          "not",
          "-",
          "p[",
          "1",
          "9".repeat(400),
          "a".repeat(300));

  private static final List<String> NESTED =
      List.of("(", "[", "p[", "f(", "a[", "not ", "-", "if a:\n", "while a:\n", "def f():\n");

  private final SplittableRandom random;

  Mutations(SplittableRandom random) {
    this.random = random;
  }

  /** Some tokens more, fewer or elsewhere; now and then more than anybody reports. */
  List<String> tokens(List<String> right) {
    List<String> tokens = new ArrayList<>(right);
    for (int i = random.nextInt(12) == 0 ? 60 : random.nextInt(5); i > 0; i--) {
      int at = random.nextInt(tokens.size());
      switch (random.nextInt(6)) {
        case 0 -> {
          if (tokens.size() > 1) {
            tokens.remove(at);
          }
        }
        case 1 -> tokens.add(at, tokens.get(random.nextInt(tokens.size())));
        case 2 -> Collections.swap(tokens, at, random.nextInt(tokens.size()));
        case 3 -> tokens.set(at, oneOf(FOREIGN));
        case 4 -> tokens.add(at, oneOf(FOREIGN));
        default -> {
          if (random.nextInt(8) == 0) {
            tokens.add(at, oneOf(NESTED).repeat(1 + random.nextInt(400)));
          }
        }
      }
    }
    return tokens;
  }

  /** The tokens as text, with blanks and line ends between them, mostly where people have them. */
  String layout(List<String> tokens) {
    StringBuilder text = new StringBuilder();
    for (String token : tokens) {
      text.append(token);
      if (!token.equals("\n")) {
        text.append(
            switch (random.nextInt(24)) {
              case 0 -> "\n";
              case 1 -> "\t";
              case 2 -> " # \"comment: (\n";
              case 3 -> "\r\n  ";
              case 4 -> "";
              default -> " ";
            });
      }
    }
    return text.toString();
  }

  /** Stray bytes in a text, bytes gone, its end cut off, or nothing of it. */
  byte[] bytes(String text) {
    byte[] bytes = text.getBytes(StandardCharsets.ISO_8859_1);
    if (random.nextInt(3) > 0 || bytes.length == 0) {
      return bytes;
    }
    if (random.nextInt(3) == 0) {
      return Arrays.copyOf(bytes, random.nextInt(bytes.length));
    }
    int rate = 1 + random.nextInt(bytes.length);
    ByteArrayOutputStream spoilt = new ByteArrayOutputStream();
    for (byte each : bytes) {
      switch (random.nextInt(rate + 3)) {
        case 0 -> spoilt.write(random.nextInt(256));
        case 1 -> {
          spoilt.write(random.nextInt(256));
          spoilt.write(each);
        }
        case 2 -> {
          // Gone.
        }
        default -> spoilt.write(each);
      }
    }
    return spoilt.toByteArray();
  }

  private String oneOf(List<String> choices) {
    return choices.get(random.nextInt(choices.size()));
  }
}
