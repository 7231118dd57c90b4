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
    assertTrue(FuzzyMatch.of("rupr", "Run program").isPresent());
    assertEquals(Optional.empty(), FuzzyMatch.of("pr", "Run a"));
    assertEquals(Optional.empty(), FuzzyMatch.of("prur", "Run program"));
    assertEquals(Optional.empty(), FuzzyMatch.of("x", ""));
  }

  @Test
  void lettersThatAreScatteredInWordsAreNoMatch() {
    assertEquals(Optional.empty(), FuzzyMatch.of("scene", "Switch the controller off and on"));
    assertEquals(Optional.empty(), FuzzyMatch.of("rnp", "Run program"));
  }

  @Test
  void lettersInARowAreFoundInsideOfWordsToo() {
    assertEquals(
        List.of("Point out", "Add: Waypoint"), filter("point", "Add: Waypoint", "Point out"));
    assertEquals(List.of("Next"), filter("n", "Undo", "Next"));
  }

  @Test
  void wordsMayComeInAnyOrderAndTheOrderOfTheTextWins() {
    assertEquals(
        List.of("Dark colours", "Colours: Dark"),
        filter("dark colours", "Colours: Dark", "Dark colours"));
    assertEquals(List.of(), filter("dark light", "Colours: Dark"));
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
        List.of("Find program", "Unprotect a file"),
        filter("pro", "Unprotect a file", "Find program"));
  }

  @Test
  void capitalsAndBlanksDoNotMatter() {
    assertEquals(List.of("Save As"), filter("SAVE as", "Save As", "Open"));
  }

  @Test
  void withoutLettersEverythingIsThereInItsOrder() {
    assertEquals(List.of("b", "a"), filter(" ", "b", "a"));
  }

  @Test
  void whatCanBeUsedComesFirstAmongThoseThatBeginAsTypedAndAmongTheOthers() {
    List<String> all = List.of("Undo: rotate pose", "Export as .urp", "Open a .urp", "Unusual rpm");
    assertEquals(
        List.of("Open a .urp", "Export as .urp", "Unusual rpm", "Undo: rotate pose"),
        FuzzyMatch.filter("urp", all, Function.identity(), text -> !text.startsWith("Export")));
  }

  @Test
  void withoutLettersWhatCanBeUsedComesFirst() {
    assertEquals(
        List.of("b", "a"),
        FuzzyMatch.filter("", List.of("a", "b"), Function.identity(), "b"::equals));
  }
}
