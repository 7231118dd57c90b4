package org.pendant.desktop.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.Joints;
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
    ComparedWays ways = new ComparedWays(List.of(way("a", false), way("b", false)), List.of());
    assertEquals(List.of("a", "b"), names(ways));
    assertEquals(2, ways.width(0));
    assertEquals(1, ways.width(1));
  }

  @Test
  void theChosenOneIsDrawnAboveTheOthersAndWider() {
    ComparedWays ways =
        new ComparedWays(List.of(way("a", true), way("b", false), way("c", false)), List.of());
    assertEquals(List.of("b", "c", "a"), names(ways));
    assertEquals(List.of(1.0, 1.0, 2.0), List.of(ways.width(0), ways.width(1), ways.width(2)));
  }

  private static ComparedWays.Ghost ghost(String name, boolean chosen, double baseRad) {
    return new ComparedWays.Ghost(
        name, 0x123456, chosen, new Joints(baseRad, -1.5, -1.5, -1.5, 1.5, 0));
  }

  @Test
  void ghostsThatAreNearerAreDrawnAboveAndTheChosenOneAboveAll() {
    ComparedWays ghosts =
        new ComparedWays(
            List.of(),
            List.of(ghost("near", false, 1), ghost("c", true, 9), ghost("far", false, 2)));
    List<ComparedWays.Ghost> drawn = ghosts.drawnGhosts(rad -> rad.get(0));
    assertEquals(
        List.of("far", "near", "c"), drawn.stream().map(ComparedWays.Ghost::name).toList());
    assertTrue(ghosts.opacity(drawn.get(2)) > 2 * ghosts.opacity(drawn.get(1)));
  }

  @Test
  void aVariantStandsInTheLegendOnce() {
    ComparedWays both =
        new ComparedWays(
            List.of(way("a", false), way("b", true)),
            List.of(ghost("b", true, 0), ghost("c", false, 0)));
    assertEquals(
        List.of("a", "b", "c"), both.legend().stream().map(ComparedWays.Entry::name).toList());
  }
}
