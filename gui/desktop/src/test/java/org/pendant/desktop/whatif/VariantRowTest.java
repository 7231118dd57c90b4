package org.pendant.desktop.whatif;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.recording.whatif.Variant;

final class VariantRowTest {
  @Test
  void whatIsTypedIsWhatIsRun() {
    Variant variant = new VariantRow("heavy", " 50 % ", "2.5kg", false).variant(Optional.empty());
    assertEquals(0.5, variant.speedFraction().orElseThrow());
    assertEquals(2.5, variant.loadKg().orElseThrow());
    assertEquals("heavy", variant.name());
  }

  @Test
  void emptyFieldsLeaveThingsAsTheyWere() {
    Variant variant = VariantRow.AS_IT_RAN.variant(Optional.empty());
    assertTrue(variant.speedFraction().isEmpty());
    assertTrue(variant.loadKg().isEmpty());
    assertTrue(variant.program().isEmpty());
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "1", "100 %", "33.5"})
  void speedsAreTaken(String typed) {
    assertEquals("", VariantRow.speedRefusal(typed));
  }

  @ParameterizedTest
  @ValueSource(strings = {"0", "101", "fast", "NaN"})
  void otherSpeedsAreRefused(String typed) {
    assertEquals(
        "Speed is '" + typed + "', must be 1 to 100 %, or empty for as it was",
        VariantRow.speedRefusal(typed));
  }

  @Test
  void loadsAreCheckedToo() {
    assertEquals("", VariantRow.loadRefusal("0"));
    assertEquals(
        "Load is '-1', must be 0 to 100 kg, or empty for as it was",
        VariantRow.loadRefusal("-1 kg"));
  }
}
