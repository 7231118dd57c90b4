package org.pendant.kit.dock;

import java.util.Locale;

/** Side of the window at which a view can be, or outside of it. */
public enum Side {
  /** In the middle, one at a time. */
  MAIN("the main area"),
  LEFT("the left"),
  RIGHT("the right"),
  /** Below the right one, as wide as that. */
  LOWER("the lower right"),
  BOTTOM("the bottom"),
  /** Each view in its own, anywhere on any screen. */
  WINDOW("a window of its own");

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
