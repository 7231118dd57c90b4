package org.pendant.desktop.testwriter;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Run words: what people are told of a test that was written. */
public final class RunWords {
  private static final int SHOWN = 2;

  private RunWords() {}

  /** That a test was saved, and what of its run is not in it. */
  public static String saved(Path file, OperatedRun facts) {
    List<String> parts = new ArrayList<>();
    parts.add("Saved " + file.getFileName());
    long unknown =
        facts.steps().stream()
            .filter(
                step ->
                    step instanceof RunStep.Asked asked
                        && asked.answer().flatMap(TestPieces::of).isEmpty())
            .count();
    if (unknown > 0) {
      parts.add(
          unknown == 1
              ? "an answer is not known, its line # operator says where it belongs"
              : unknown + " answers are not known, lines # operator say where they belong");
    }
    List<String> left = facts.left();
    if (!left.isEmpty()) {
      String more =
          left.size() > SHOWN
              ? "; and " + (left.size() - SHOWN) + " more, which its first lines name"
              : "";
      parts.add("not in it: " + String.join("; ", left.stream().limit(SHOWN).toList()) + more);
    }
    return String.join(". ", parts.stream().map(RunWords::capital).toList());
  }

  private static String capital(String words) {
    return Character.toUpperCase(words.charAt(0)) + words.substring(1);
  }
}
