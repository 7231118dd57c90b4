package org.pendant.desktop.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.recording.whatif.TcpWay;

final class ComparedWaysTest {
  private static ComparedWays.Way way(String name, boolean chosen) {
    return new ComparedWays.Way(name, 0x123456, chosen, TcpWay.NONE);
  }

  private static List<String> names(ComparedWays ways) {
    return ways.drawn().stream().map(ComparedWays.Way::name).toList();
  }

  @Test
  void thoseBelowAreWiderThanThoseAbove() {
    ComparedWays ways = new ComparedWays(List.of(way("a", false), way("b", false)));
    assertEquals(List.of("a", "b"), names(ways));
    assertEquals(2, ways.width(0));
    assertEquals(1, ways.width(1));
  }

  @Test
  void theChosenOneIsDrawnAboveTheOthersAndWider() {
    ComparedWays ways = new ComparedWays(List.of(way("a", true), way("b", false), way("c", false)));
    assertEquals(List.of("b", "c", "a"), names(ways));
    assertEquals(List.of(1.0, 1.0, 2.0), List.of(ways.width(0), ways.width(1), ways.width(2)));
  }
}
