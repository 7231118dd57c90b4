package org.pendant.text;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.TreeSet;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

final class TextLiteralsTest {
  /** Modules of which everything that people read is in bundles. */
  private static final List<String> MODULES =
      List.of(
          "gui/kit/src/main/java",
          "gui/desktop/src/main/java",
          "gui/editors/src/main/java",
          "gui/command/src/main/java",
          "gui/spark/src/main/java",
          "protocols/src/main/java",
          "language/src/main/java",
          "controller/script/src/main/java",
          "controller/core/src/main/java",
          "controller/project/src/main/java",
          "controller/recording/src/main/java",
          "controller/sweep/src/main/java",
          "controller/motion/src/main/java",
          "controller/testing/src/main/java",
          "controller/cell/src/main/java",
          "controller/text/src/main/java",
          "controller/junit/src/main/java",
          "models/src/main/java");

  /** How a line of the list ends that is of whole classes: what they say goes out on ports. */
  private static final String EVERYTHING = "*";

  @Test
  void wordsAreTextsAndNamesConstraintsAndKeysAreNot() {
    assertTrue(TextLiterals.isText("Run or resume program"));
    assertTrue(TextLiterals.isText("Run"));
    assertTrue(TextLiterals.isText(" is not a number"));
    assertTrue(TextLiterals.isText("Speed: "));
    assertFalse(TextLiterals.isText("program.run"));
    assertFalse(TextLiterals.isText("insets 0, gap 8, wrap 2"));
    assertFalse(TextLiterals.isText("[grow, fill][]8[pref!]"));
    assertFalse(TextLiterals.isText("control shift P"));
    assertFalse(TextLiterals.isText("actual_TCP_pose"));
  }

  @Test
  void aTextInCodeIsFoundUnlessItIsForProgrammers(@TempDir Path folder) throws IOException {
    Path source =
        Files.writeString(
            folder.resolve("Card.java"),
            """
            package org.pendant;
            class Card {
              String title = "Last run";
              @SuppressWarnings("not a text") String of(int n) {
                if (n < 0) throw new IllegalArgumentException("n is negative: " + n);
                return switch (n) { case 0 -> "nothing yet"; default -> text("runs", n); };
              }
            }
            """);
    assertEquals(
        List.of("org.pendant.Card: Last run", "org.pendant.Card: nothing yet"),
        TextLiterals.of(List.of(source)));
  }

  /**
   * What only looks like a text is listed in the resource {@code literals-that-stay.txt}; there
   * {@code org.pendant.protocols.robotapi.*} stands for all that is in classes of that package.
   */
  @Test
  @Tag("slow")
  void noTextIsInCode() throws IOException {
    TreeSet<String> staying = staying();
    TreeSet<String> found = new TreeSet<>();
    for (String module : MODULES) {
      TextLiterals.of(TextBundles.sourcesUnder(module)).stream()
          .map(literal -> listed(literal, staying))
          .forEach(found::add);
    }
    assertEquals(String.join("\n", staying), String.join("\n", found));
  }

  /** The line of the list that a literal falls under; the literal itself if there is none. */
  private static String listed(String literal, TreeSet<String> staying) {
    return staying.stream()
        .filter(line -> line.endsWith(EVERYTHING))
        .filter(line -> literal.startsWith(line.substring(0, line.length() - 1)))
        .findFirst()
        .orElse(literal);
  }

  private static TreeSet<String> staying() throws IOException {
    try (InputStream in = TextLiteralsTest.class.getResourceAsStream("literals-that-stay.txt")) {
      String list = new String(in.readAllBytes(), StandardCharsets.UTF_8);
      return new TreeSet<>(list.lines().filter(line -> !line.startsWith("#")).toList());
    }
  }
}
