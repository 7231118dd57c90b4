package org.pendant.models.arm;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.EnumSet;
import java.util.Set;
import org.junit.jupiter.api.Test;

class ConfidenceTest {
  @Test
  void wordsLeadBackToTheirConstant() {
    for (Confidence each : Confidence.values()) {
      assertEquals(each, Confidence.named(each.word()));
    }
    assertEquals("measured", Confidence.MEASURED.word());
  }

  @Test
  void otherWordsAreRefused() {
    assertEquals(
        "status is VERIFIED, must be verified, measured, derived, assumed, estimated or missing",
        assertThrows(IllegalArgumentException.class, () -> Confidence.named("VERIFIED"))
            .getMessage());
  }

  @Test
  void onlyWhatWasTakenFromTheModelItselfIsOfThisModel() {
    Set<Confidence> own = EnumSet.noneOf(Confidence.class);
    for (Confidence each : Confidence.values()) {
      if (each.ofThisModel()) {
        own.add(each);
      }
    }
    assertEquals(EnumSet.of(Confidence.VERIFIED, Confidence.MEASURED), own);
  }
}
