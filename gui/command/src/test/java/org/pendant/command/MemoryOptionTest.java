package org.pendant.command;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.controller.ControllerOptions;

final class MemoryOptionTest {
  private static final long MOST = 2_000_000_000;

  @ParameterizedTest
  @CsvSource({
    "256MB, 256000000",
    "1GB, 1000000000",
    "1.5gb, 1500000000",
    "500 kB, 500000",
  })
  void aSizeIsANumberWithAUnit(String text, long bytes) throws UsageException {
    assertEquals(bytes, MemoryOption.bytes(text, MOST));
  }

  @Test
  void withoutTheOptionTheStandardSizeCounts() throws UsageException {
    assertEquals(
        ControllerOptions.standardMemoryBytes(),
        MemoryOption.of(Arguments.parse(List.of(MemoryOption.OPTION), List.of())));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          much  | must be a number with kB, MB or GB, such as 256MB
          256   | must be a number with kB, MB or GB, such as 256MB
          -1MB  | must be a number with kB, MB or GB, such as 256MB
          1kB   | must be at least 100kB
          3GB   | must be at most 2000MB, a third of Java's memory; PENDANT_JAVA_OPTIONS=-Xmx8584m makes room for it
          """)
  void otherSizesAreRefusedWithWhatWouldBeRight(String text, String reason) {
    assertEquals(
        "--memory is " + text + ", " + reason,
        assertThrows(UsageException.class, () -> MemoryOption.bytes(text, MOST)).getMessage());
  }
}
