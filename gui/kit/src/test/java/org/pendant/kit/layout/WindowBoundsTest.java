package org.pendant.kit.layout;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.awt.Dimension;
import java.awt.Rectangle;
import java.util.List;
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
  void aWindowStaysOnTheScreenItTouches() {
    Rectangle left = new Rectangle(0, 0, 1024, 700);
    Rectangle right = new Rectangle(1024, 0, 1920, 1080);
    List<Rectangle> screens = List.of(left, right);
    assertEquals(
        Optional.of(new Rectangle(0, 0, 1024, 700)),
        WindowBounds.within(new Rectangle(-50, -20, 1440, 900), screens));
    assertEquals(
        Optional.of(new Rectangle(1504, 180, 1440, 900)),
        WindowBounds.within(new Rectangle(2000, 600, 1440, 900), screens));
    assertEquals(Optional.empty(), WindowBounds.within(new Rectangle(5000, 0, 800, 600), screens));
  }

  @Test
  void aSecondWindowGoesToTheScreenThatTheFirstIsNotOn() {
    Rectangle first = new Rectangle(100, 50, 800, 600);
    Rectangle left = new Rectangle(0, 0, 1024, 700);
    Rectangle right = new Rectangle(1024, 0, 1920, 1080);
    Dimension size = new Dimension(500, 400);
    assertEquals(
        new Rectangle(1734, 340, 500, 400), WindowBounds.second(first, List.of(left, right), size));
    assertEquals(
        new Rectangle(180, 130, 500, 400), WindowBounds.second(first, List.of(left), size));
    Rectangle whole = new Rectangle(0, 0, 1024, 700);
    assertEquals(
        new Rectangle(24, 0, 1000, 700),
        WindowBounds.second(whole, List.of(left), new Dimension(1000, 900)));
  }

  @Test
  void theUsualWindowFitsOnTheScreen() {
    assertEquals(
        new Rectangle(0, 0, 1024, 700), WindowBounds.usual(new Rectangle(0, 0, 1024, 700)));
    assertEquals(
        new Rectangle(240, 90, 1440, 900), WindowBounds.usual(new Rectangle(0, 0, 1920, 1080)));
  }
}
