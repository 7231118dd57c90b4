package org.pendant.kit.dock;

import static org.pendant.kit.dock.DockTexts.text;

import java.util.Locale;

/** Side of the window at which a view can be, or outside of it. */
public enum Side {
  /** In the middle, one at a time. */
  MAIN(text("theMainArea")),
  LEFT(text("theLeft")),
  RIGHT(text("theRight")),
  /** Below the right one, as wide as that. */
  LOWER(text("theLowerRight")),
  BOTTOM(text("theBottom")),
  /** Each view in its own, anywhere on any screen. */
  WINDOW(text("aWindowOfItsOwn"));

  private final String title;

  Side(String title) {
    this.title = title;
  }

  /** Such as {@code the left}. */
  public String title() {
    return title;
  }

  /** The word in settings and ids. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }
}
