package org.pendant.desktop.editor;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

final class LineIconTest {
  private static List<Optional<LineIcon.Dot>> dots() {
    List<Optional<LineIcon.Dot>> dots = new ArrayList<>();
    dots.add(Optional.empty());
    for (LineIcon.Reach reach : LineIcon.Reach.values()) {
      for (boolean filled : new boolean[] {false, true}) {
        for (LineIcon.Kind kind : LineIcon.Kind.values()) {
          dots.add(Optional.of(new LineIcon.Dot(filled, kind, reach)));
        }
      }
    }
    return dots;
  }

  private static List<Optional<Execution.State>> arrows() {
    List<Optional<Execution.State>> arrows = new ArrayList<>();
    arrows.add(Optional.empty());
    Arrays.stream(Execution.State.values()).map(Optional::of).forEach(arrows::add);
    return arrows;
  }

  @Test
  void everythingThatStandsBesideALineHasADrawing() {
    for (Optional<LineIcon.Dot> dot : dots()) {
      for (Optional<Execution.State> arrow : arrows()) {
        LineIcon icon = new LineIcon(dot, arrow, true);
        int parts = 1 + (dot.isPresent() ? 1 : 0) + (arrow.isPresent() ? 1 : 0);
        assertEquals(parts, icon.layers().size(), icon::toString);
        icon.layers().forEach(each -> assertTrue(each.hasFound(), each::getName));
      }
    }
  }
}
