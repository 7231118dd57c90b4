package org.pendant.desktop.whatif;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.desktop.session.ProgramDocument;

final class VariantSubjectTest {
  private final ProgramDocument ran = ProgramDocument.untitled("ran.script", "");
  private final ProgramDocument front = ProgramDocument.untitled("front.script", "");
  private final ProgramDocument other = ProgramDocument.untitled("other.script", "");

  @Test
  void variantsAreSeenWithTheProgramThatRanAndThatInFrontOfWhichTheyWereRun() {
    VariantSubject subject = new VariantSubject(Optional.of(ran), front);
    assertTrue(subject.seenWith(ran));
    assertTrue(subject.seenWith(front));
    assertFalse(subject.seenWith(other));
    assertEquals("ran.script", subject.name());
  }

  @Test
  void variantsOfAProgramFromOutsideAreSeenWithTheOneInFront() {
    VariantSubject subject = new VariantSubject(Optional.empty(), front);
    assertTrue(subject.seenWith(front));
    assertFalse(subject.seenWith(other));
    assertEquals("front.script", subject.name());
  }
}
