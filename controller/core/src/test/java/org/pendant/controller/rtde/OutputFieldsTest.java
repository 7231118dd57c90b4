package org.pendant.controller.rtde;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;

class OutputFieldsTest {
  /** Lines {@code name,type} of all fields that the interface has. */
  private static List<String> expected() throws IOException {
    try (InputStream table = OutputFieldsTest.class.getResourceAsStream("output-fields.csv")) {
      return new String(table.readAllBytes(), StandardCharsets.US_ASCII).lines().skip(1).toList();
    }
  }

  @Test
  void everyFieldOfTheInterfaceIsThereWithItsTypeAndNoOther() throws IOException {
    List<String> present =
        OutputFields.all().stream()
            .map(field -> field.name() + "," + field.type())
            .sorted()
            .toList();
    assertEquals(expected().stream().sorted().toList(), present);
  }

  @Test
  void aFieldIsFoundByItsExactName() {
    assertTrue(OutputFields.of("actual_TCP_pose").isPresent());
    assertTrue(OutputFields.of("actual_tcp_pose").isEmpty());
    assertTrue(OutputFields.of("").isEmpty());
  }
}
