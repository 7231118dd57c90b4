package org.pendant.desktop.testwriter;

import static org.pendant.desktop.testwriter.TestWriterTexts.text;

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
    parts.add(text("saved", file.getFileName()));
    long unknown =
        facts.steps().stream()
            .filter(
                step ->
                    step instanceof RunStep.Asked asked
                        && asked.answer().flatMap(TestPieces::of).isEmpty())
            .count();
    if (unknown > 0) {
      parts.add(unknown == 1 ? text("anAnswerIsNotKnown") : text("answersAreNotKnown", unknown));
    }
    List<String> left = facts.left();
    if (!left.isEmpty()) {
      String named = String.join("; ", left.stream().limit(SHOWN).toList());
      parts.add(
          left.size() > SHOWN
              ? text("notInItAndMore", named, left.size() - SHOWN)
              : text("notInIt", named));
    }
    return String.join(". ", parts.stream().map(RunWords::capital).toList());
  }

  private static String capital(String words) {
    return Character.toUpperCase(words.charAt(0)) + words.substring(1);
  }
}
