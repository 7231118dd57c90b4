package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.SavedProgram;
import org.pendant.language.source.Source;

final class ReceivedProgramTest {
  private final ProgramDocument own = ProgramDocument.untitled("own.script", "x = 1\n");
  private final Programs programs = new Programs(own);
  private final ReceivedProgram received = new ReceivedProgram(programs);

  private ProgramDocument show(String name, String text) {
    return received.show(Optional.of(Source.of(name, text))).orElseThrow();
  }

  @Test
  void aProgramFromOutsideIsOpenBehindTheOneInFront() {
    ProgramDocument shown = show("visitor", "def visitor():\r\nend\r\n");
    assertEquals(List.of(own, shown), programs.all());
    assertSame(own, programs.current());
    assertEquals("visitor.script", shown.name());
    assertEquals("def visitor():\nend\n", shown.text());
    assertTrue(shown.received());
    assertFalse(shown.modified());
  }

  @Test
  void theSameProgramSentAgainKeepsItsPlace() {
    ProgramDocument first = show("visitor", "a\n");
    assertSame(first, show("visitor", "b\n"));
    assertEquals("b\n", first.text());
    assertFalse(first.modified());
  }

  @Test
  void theNextProgramTakesThePlaceOfTheOneBefore() {
    ProgramDocument first = show("first", "a\n");
    programs.select(first);
    ProgramDocument second = show("second", "b\n");
    assertEquals(List.of(own, second), programs.all());
    assertSame(second, programs.current());
  }

  @Test
  void oneThatPeopleHaveSavedIsTheirs() {
    ProgramDocument first = show("first", "a\n");
    first.saved(SavedProgram.create(Path.of("first.script"), "a\n"));
    assertFalse(first.received());
    ProgramDocument second = show("first", "b\n");
    assertEquals(List.of(own, first, second), programs.all());
    assertEquals("a\n", first.text());
  }

  @Test
  void oneThatPeopleHaveClosedIsOpenedAgain() {
    programs.close(show("visitor", "a\n"), own);
    assertEquals(Optional.empty(), received.shown());
    ProgramDocument again = show("visitor", "a\n");
    assertEquals(Optional.of(again), received.shown());
  }

  @Test
  void whatIsNotKnownIsNotShown() {
    show("visitor", "a\n");
    assertEquals(Optional.empty(), received.show(Optional.empty()));
    assertEquals(List.of(own), programs.all());
  }
}
