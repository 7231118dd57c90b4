package org.pendant.models.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.Map;
import org.junit.jupiter.api.Test;

final class JsonMembersTest {

  @Test
  void eachHasItsOwnText() {
    assertEquals(
        Map.of("a", "[1, [2, \"]\"],\n  3]", "b", "7", "c", "{\"d\" : {}}", "e", "\"f\\\"g\""),
        JsonMembers.of(
            "{\"a\": [1, [2, \"]\"],\n  3], \"b\": 7,\n\"c\":{\"d\" : {}}, \"e\": \"f\\\"g\"}"));
  }

  @Test
  void whatIsNoObjectIsRefused() {
    assertThrows(IllegalArgumentException.class, () -> JsonMembers.of("[1]"));
    assertThrows(IllegalArgumentException.class, () -> JsonMembers.of("{\"a\": [1}"));
  }
}
