package org.pendant.desktop.scene.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.pendant.desktop.scene.view.LabelPlaces.Label;
import org.pendant.desktop.scene.view.LabelPlaces.Placed;

final class LabelPlacesTest {
  private static final Rectangle2D ROOM = new Rectangle2D.Double(0, 0, 400, 300);

  private static Label label(String text, double x, double y, boolean chosen) {
    return new Label(text, new Point2D.Double(x, y), 0, chosen);
  }

  private static List<Placed> placed(List<Label> labels, Rectangle2D... taken) {
    return LabelPlaces.of(labels, 12, 18, text -> 7 * text.length(), ROOM, List.of(taken));
  }

  @Test
  void aNameAloneStandsBesideItsPointWithoutALine() {
    Placed only = placed(List.of(label("Feeder", 100, 100, false))).getFirst();
    assertFalse(only.apart());
    assertTrue(LabelPlaces.distance(only.box(), only.label().at()) < 13);
  }

  @Test
  void namesOfPointsThatLieTogetherDoNotLieOnEachOther() {
    SplittableRandom random = new SplittableRandom(3);
    List<Label> labels = new ArrayList<>();
    for (int i = 0; i < 12; i++) {
      labels.add(label("Corner_" + i, 180 + random.nextInt(40), 130 + random.nextInt(40), false));
    }
    List<Placed> all = placed(labels);
    assertTrue(all.size() > 6, all.size() + " have room");
    for (Placed one : all) {
      assertTrue(ROOM.contains(one.box()), () -> one + " is cut");
      for (Placed other : all) {
        assertTrue(
            one.equals(other) || !one.box().intersects(other.box()), () -> one + " on " + other);
      }
    }
    assertTrue(all.stream().anyMatch(Placed::apart), "some have a line to their point");
  }

  @Test
  void namesOfPointsOutOfSightAreLeftOut() {
    assertEquals(
        List.of("in"),
        placed(List.of(label("out", -20, 100, true), label("in", 20, 100, false))).stream()
            .map(each -> each.label().text())
            .toList());
  }

  @Test
  void theChosenNameIsSeenInAnyCaseAndWhatIsTakenStaysFree() {
    Rectangle2D all = new Rectangle2D.Double(0, 0, 400, 300);
    List<Label> labels = List.of(label("A", 100, 100, false), label("B", 110, 100, true));
    assertEquals(
        List.of("B"), placed(labels, all).stream().map(each -> each.label().text()).toList());
    Rectangle2D legend = new Rectangle2D.Double(0, 200, 400, 100);
    for (Placed each : placed(List.of(label("low", 50, 195, false)), legend)) {
      assertFalse(each.box().intersects(legend));
    }
  }
}
