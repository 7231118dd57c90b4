package org.pendant.desktop.program;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Locale;
import org.junit.jupiter.api.Test;

/** What is done to nodes, as the history of a program calls it. */
final class NodeChangeTest {
  @Test
  void oneNodeIsNamedAndSeveralAreCounted() {
    assertEquals("Delete Wait", NodeChange.DELETE.ofOne("Wait"));
    assertEquals("Delete 3 nodes", NodeChange.DELETE.of(3));
  }

  @Test
  void everyChangeHasAVerbOfItsOwn() {
    for (NodeChange each : NodeChange.values()) {
      String verb = each.name().charAt(0) + each.name().substring(1).toLowerCase(Locale.ROOT);
      assertEquals(verb + " Wait", each.ofOne("Wait"));
      assertEquals(verb + " 2 nodes", each.of(2));
    }
  }
}
