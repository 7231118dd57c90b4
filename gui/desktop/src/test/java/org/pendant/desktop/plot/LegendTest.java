package org.pendant.desktop.plot;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;

final class LegendTest {
  @Test
  void whatAllNamesBeginWithStandsOnce() {
    List<String> names = List.of("Actual position, base", "Actual position, elbow");
    assertEquals("Actual position", Legend.common(names));
    assertEquals("elbow", Legend.below(Legend.common(names), names.getLast()));
  }

  @Test
  void namesOfOneLineOrOfDifferentQuantitiesStandWhole() {
    assertEquals("", Legend.common(List.of("TCP speed, length")));
    assertEquals("", Legend.common(List.of("TCP speed, length", "Actual position, base")));
    assertEquals("", Legend.common(List.of("count", "part")));
    assertEquals("Gripper (Output 3)", Legend.below("", "Gripper (Output 3)"));
  }
}
