package org.pendant.language.check;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;

/** Names that are missing in many places are told once. */
final class MissingNamesTest {

  @Test
  void eachMissingNameIsToldOnceWithTheLinesOfItsNextUses() {
    String body = "x = gone(1)\ny = colour\ngone(2)\ngone(3)\nz = colour\ngone(4)\ngone(5)";
    assertEquals(
        List.of(
            "2: function gone is not defined (and in 4 more places: lines 4, 5, 7, ...)",
            "3: variable colour is never assigned (and in another place: line 6)"),
        told("def prog():\n" + body + "\nend\n"));
  }

  @Test
  void aFunctionAndAVariableOfOneNameAreTwoThings() {
    assertEquals(
        List.of("2: function zzzzzz is not defined", "3: variable zzzzzz is never assigned"),
        told("def prog():\nzzzzzz()\nx = zzzzzz\nend\n"));
  }

  @Test
  void whatElseIsWrongIsToldInEachPlace() {
    assertEquals(
        List.of(
            "2: sleep is called without t; expected sleep(t)",
            "3: sleep is called without t; expected sleep(t)"),
        told("def prog():\nsleep()\nsleep()\nend\n"));
  }

  @Test
  void manyUsesOfOneNameDoNotUseUpTheOffersForOthers() {
    StringBuilder text = new StringBuilder("def prog():\n");
    IntStream.range(0, 200).forEach(_ -> text.append("zzzzzzzz()\n"));
    assertEquals(
        List.of(
            "2: function zzzzzzzz is not defined (and in 199 more places: lines 3, 4, 5, ...)",
            "202: variable Tru is never assigned; did you mean True?"),
        told(text + "x = Tru\nend\n"));
  }

  @Test
  void aLibraryMayHaveNamesFromElsewhere() {
    String text = "def g(a):\n  gone(colour)\n  gone(a)\n  sleep()\nend\n";
    assertEquals(
        List.of(
            "2:unknown-function", "2:unknown-variable", "3:unknown-function", "4:missing-argument"),
        Checks.found(text));
    assertEquals(
        List.of(false, false, false, false),
        Checks.diagnostics(text).stream().map(Diagnostic::isError).toList());
    assertEquals(
        "2: function gone is not defined in this library (and in another place: line 3)",
        told(text).getFirst());
  }

  private static List<String> told(String text) {
    Source source = Source.of("test.script", text);
    return MissingNames.together(source, Checks.diagnostics(text)).stream()
        .map(each -> source.line(each.range().start()) + ": " + each.message())
        .toList();
  }
}
