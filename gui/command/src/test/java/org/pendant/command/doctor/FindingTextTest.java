package org.pendant.command.doctor;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Locale;
import org.junit.jupiter.api.Test;

final class FindingTextTest {
  @Test
  void countsAreGroupedAsInEnglishWhateverTheSystemSpeaks() {
    Locale before = Locale.getDefault();
    Locale.setDefault(Locale.GERMANY);
    try {
      assertEquals("66,851", FindingText.count(66_851).english());
    } finally {
      Locale.setDefault(before);
    }
  }
}
