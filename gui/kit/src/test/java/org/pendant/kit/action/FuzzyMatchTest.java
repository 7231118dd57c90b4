package org.pendant.kit.action;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.junit.jupiter.api.Test;

final class FuzzyMatchTest {
  private static List<String> filter(String query, String... texts) {
    return FuzzyMatch.filter(query, List.of(texts), Function.identity());
  }

  @Test
  void lettersMustOccurInTheirOrder() {
    assertTrue(FuzzyMatch.of("rnp", "Run program").isPresent());
    assertEquals(Optional.empty(), FuzzyMatch.of("pnr", "Run program"));
    assertEquals(Optional.empty(), FuzzyMatch.of("x", ""));
  }

  @Test
  void lettersInARowAtTheBeginWin() {
    assertEquals(
        List.of("Stop program", "Switch the arm off", "Move Script to the left"),
        filter("st", "Move Script to the left", "Switch the arm off", "Stop program"));
  }

  @Test
  void beginsOfWordsWinOverLettersInside() {
    assertEquals(
        List.of("Find program", "Stuff a plan"), filter("fp", "Stuff a plan", "Find program"));
  }

  @Test
  void capitalsAndBlanksDoNotMatter() {
    assertEquals(List.of("Save As"), filter("SAVE as", "Save As", "Open"));
  }

  @Test
  void withoutLettersEverythingIsThereInItsOrder() {
    assertEquals(List.of("b", "a"), filter(" ", "b", "a"));
  }
}
