package org.pendant.gui.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Rectangle;
import java.util.Optional;
import org.junit.jupiter.api.Test;

final class WindowBoundsTest {
  @Test
  void boundsSurviveTheSettings() {
    Rectangle bounds = new Rectangle(-12, 30, 1024, 700);
    assertEquals(Optional.of(bounds), WindowBounds.parse(WindowBounds.format(bounds)));
  }

  @Test
  void textsThatAreNoBoundsAreIgnored() {
    assertEquals(Optional.empty(), WindowBounds.parse(""));
    assertEquals(Optional.empty(), WindowBounds.parse("1 2 3"));
    assertEquals(Optional.empty(), WindowBounds.parse("0 0 -5 100"));
  }

  @Test
  void theUsualWindowFitsOnTheScreen() {
    assertEquals(
        new Rectangle(0, 0, 1024, 700), WindowBounds.usual(new Rectangle(0, 0, 1024, 700)));
    assertEquals(
        new Rectangle(240, 90, 1440, 900), WindowBounds.usual(new Rectangle(0, 0, 1920, 1080)));
  }
}
