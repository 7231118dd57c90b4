package org.pendant.kit.layout;

import java.awt.Dimension;
import java.awt.GraphicsConfiguration;
import java.awt.GraphicsDevice;
import java.awt.GraphicsEnvironment;
import java.awt.Insets;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** Window bounds: where a window is, as settings have it: x, y, width, height. */
public final class WindowBounds {
  private static final int WIDTH = 1440;
  private static final int HEIGHT = 900;

  /** How far windows that lie over one another are apart, pixels. */
  private static final int STEP = 40;

  /** A window that is narrower than this is of no use, pixels. */
  private static final int MIN_WIDTH = 320;

  private WindowBounds() {}

  /** What windows may cover of each screen that there is. */
  public static List<Rectangle> screens() {
    return Stream.of(GraphicsEnvironment.getLocalGraphicsEnvironment().getScreenDevices())
        .map(GraphicsDevice::getDefaultConfiguration)
        .map(WindowBounds::room)
        .toList();
  }

  private static Rectangle room(GraphicsConfiguration screen) {
    Rectangle bounds = screen.getBounds();
    Insets taken = Toolkit.getDefaultToolkit().getScreenInsets(screen);
    return new Rectangle(
        bounds.x + taken.left,
        bounds.y + taken.top,
        bounds.width - taken.left - taken.right,
        bounds.height - taken.top - taken.bottom);
  }

  /** As much of the screen as is useful, in its middle. */
  public static Rectangle usual(Rectangle screen) {
    return middle(
        screen, new Dimension(Math.min(WIDTH, screen.width), Math.min(HEIGHT, screen.height)));
  }

  /**
   * The bounds on the first screen that they touch, no larger than that; empty if they touch none.
   *
   * @param screens what of each can be used
   */
  public static Optional<Rectangle> within(Rectangle bounds, List<Rectangle> screens) {
    return screens.stream()
        .filter(bounds::intersects)
        .findFirst()
        .map(
            screen -> {
              int width = Math.min(bounds.width, screen.width);
              int height = Math.min(bounds.height, screen.height);
              return new Rectangle(
                  Math.clamp(bounds.x, screen.x, screen.x + screen.width - width),
                  Math.clamp(bounds.y, screen.y, screen.y + screen.height - height),
                  width,
                  height);
            });
  }

  /**
   * Where a second window goes: to the middle of the first screen that {@code first} is not on;
   * else beside it, where it may be narrower; else into the lower right corner of {@code area},
   * which people look at least.
   *
   * @param first the bounds of the window that is there already
   * @param area what it holds, on the screen
   * @param others windows that are there as well: above or beside them, while there is room; else
   *     it leaves their heads in sight
   * @param screens what of each screen can be used
   */
  public static Rectangle second(
      Rectangle first,
      Rectangle area,
      List<Rectangle> others,
      List<Rectangle> screens,
      Dimension size) {
    Rectangle wanted =
        screens.stream()
            .filter(screen -> !screen.intersects(first))
            .findFirst()
            .map(screen -> middle(screen, size))
            .or(() -> beside(first, screens, size))
            .orElseGet(
                () ->
                    new Rectangle(
                        area.x + area.width - size.width,
                        area.y + area.height - size.height,
                        size.width,
                        size.height));
    Rectangle free = within(wanted, screens).orElse(wanted);
    return Stream.of(new Point(0, 0), new Point(0, -1), new Point(-1, 0), new Point(-1, -1))
        .map(each -> moved(free, each.x * free.width, each.y * free.height))
        .filter(place -> screens.stream().anyMatch(screen -> screen.contains(place)))
        .filter(place -> others.stream().noneMatch(place::intersects))
        .findFirst()
        .orElseGet(
            () -> cascaded(new Rectangle(area.getLocation(), free.getSize()), others, screens));
  }

  /** Below and to the right of others, whose heads it leaves in sight. */
  private static Rectangle cascaded(
      Rectangle from, List<Rectangle> others, List<Rectangle> screens) {
    Rectangle place = from;
    for (int i = 0; i < others.size() && nearOneOf(others, place); i++) {
      place = moved(place, STEP, STEP);
    }
    return within(place, screens).orElse(place);
  }

  private static Rectangle moved(Rectangle from, int x, int y) {
    return new Rectangle(from.x + x, from.y + y, from.width, from.height);
  }

  /** Frames of windows may shift them a little. */
  private static boolean nearOneOf(List<Rectangle> others, Rectangle place) {
    return others.stream()
        .anyMatch(each -> each.getLocation().distance(place.getLocation()) < STEP);
  }

  private static Optional<Rectangle> beside(
      Rectangle first, List<Rectangle> screens, Dimension size) {
    return screens.stream()
        .filter(first::intersects)
        .findFirst()
        .flatMap(
            screen -> {
              int right = screen.x + screen.width - first.x - first.width;
              int left = first.x - screen.x;
              int width = Math.min(size.width, Math.max(right, left));
              int x = right >= left ? first.x + first.width : first.x - width;
              int y = first.y + Math.max(0, first.height - size.height) / 2;
              return width >= MIN_WIDTH
                  ? Optional.of(new Rectangle(x, y, width, size.height))
                  : Optional.empty();
            });
  }

  private static Rectangle middle(Rectangle screen, Dimension size) {
    return new Rectangle(
        screen.x + (screen.width - size.width) / 2,
        screen.y + (screen.height - size.height) / 2,
        size.width,
        size.height);
  }

  /** As {@link #parse} reads it. */
  public static String format(Rectangle bounds) {
    return bounds.x + " " + bounds.y + " " + bounds.width + " " + bounds.height;
  }

  /** Empty for texts that are no bounds. */
  public static Optional<Rectangle> parse(String text) {
    if (!text.matches("-?\\d{1,5} -?\\d{1,5} \\d{2,5} \\d{2,5}")) {
      return Optional.empty();
    }
    String[] parts = text.split(" ", -1);
    return Optional.of(
        new Rectangle(
            Integer.parseInt(parts[0]),
            Integer.parseInt(parts[1]),
            Integer.parseInt(parts[2]),
            Integer.parseInt(parts[3])));
  }
}
