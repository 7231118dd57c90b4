package org.pendant.kit.layout;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Dimension;
import java.awt.Rectangle;
import java.util.ArrayList;
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
    assertEquals(
        new Rectangle(1734, 340, 500, 400), second(first, List.of(), List.of(left, right)));
  }

  /** A window of 500 x 400; what the first one holds is between its head and its foot. */
  private static Rectangle second(
      Rectangle first, List<Rectangle> others, List<Rectangle> screens) {
    Rectangle area = new Rectangle(first.x, first.y + 100, first.width, first.height - 150);
    return WindowBounds.second(first, area, others, screens, new Dimension(500, 400));
  }

  @Test
  void aSecondWindowGoesBesideTheFirstWhereTheScreenHasRoom() {
    List<Rectangle> screen = List.of(new Rectangle(0, 0, 1920, 1080));
    assertEquals(
        new Rectangle(1000, 200, 500, 400),
        second(new Rectangle(0, 0, 1000, 800), List.of(), screen));
    assertEquals(
        new Rectangle(420, 240, 500, 400),
        second(new Rectangle(920, 40, 1000, 800), List.of(), screen));
    assertEquals(
        new Rectangle(1540, 250, 380, 400),
        second(new Rectangle(100, 50, 1440, 800), List.of(), screen),
        "narrower");
  }

  @Test
  void elseItGoesToTheLowerRightOfWhatTheFirstHolds() {
    List<Rectangle> screen = List.of(new Rectangle(0, 0, 1600, 1000));
    assertEquals(
        new Rectangle(940, 450, 500, 400),
        second(new Rectangle(0, 0, 1440, 900), List.of(), screen));
    assertEquals(
        new Rectangle(524, 250, 500, 400),
        second(new Rectangle(0, 0, 1024, 700), List.of(), List.of(new Rectangle(0, 0, 1024, 700))));
  }

  @Test
  void furtherWindowsCoverNoneOfTheOthersWhileThereIsRoom() {
    List<Rectangle> screen = List.of(new Rectangle(0, 0, 1600, 1000));
    Rectangle first = new Rectangle(0, 0, 1440, 900);
    List<Rectangle> others = new ArrayList<>();
    for (int i = 0; i < 4; i++) {
      Rectangle next = second(first, others, screen);
      assertTrue(screen.getFirst().contains(next), next::toString);
      assertTrue(others.stream().noneMatch(next::intersects), () -> next + " over " + others);
      others.add(next);
    }
  }

  @Test
  void thenTheyLeaveTheHeadsOfTheOthersInSight() {
    List<Rectangle> screen = List.of(new Rectangle(0, 0, 1024, 700));
    Rectangle first = new Rectangle(0, 0, 1024, 700);
    // the frame of a window has shifted it
    List<Rectangle> others =
        List.of(
            new Rectangle(524, 250, 500, 400),
            new Rectangle(300, 120, 500, 400),
            new Rectangle(1, 105, 500, 400));
    assertEquals(new Rectangle(40, 140, 500, 400), second(first, others, screen));
  }

  @Test
  void theUsualWindowFitsOnTheScreen() {
    assertEquals(
        new Rectangle(0, 0, 1024, 700), WindowBounds.usual(new Rectangle(0, 0, 1024, 700)));
    assertEquals(
        new Rectangle(240, 90, 1440, 900), WindowBounds.usual(new Rectangle(0, 0, 1920, 1080)));
  }
}
