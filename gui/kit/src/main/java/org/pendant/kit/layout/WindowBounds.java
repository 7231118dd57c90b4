package org.pendant.kit.layout;

import java.awt.Rectangle;
import java.util.List;
import java.util.Optional;

/** Window bounds: where a window is, as settings have it: x, y, width, height. */
public final class WindowBounds {
  private static final int WIDTH = 1440;
  private static final int HEIGHT = 900;

  private WindowBounds() {}

  /** As much of the screen as is useful, in its middle. */
  public static Rectangle usual(Rectangle screen) {
    int width = Math.min(WIDTH, screen.width);
    int height = Math.min(HEIGHT, screen.height);
    return new Rectangle(
        screen.x + (screen.width - width) / 2,
        screen.y + (screen.height - height) / 2,
        width,
        height);
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
