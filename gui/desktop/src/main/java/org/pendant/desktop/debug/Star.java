package org.pendant.desktop.debug;

import org.pendant.kit.icon.SvgIcon;

/** Star: full for a favourite, an outline for what could be one. */
public final class Star {
  private static final SvgIcon FULL = SvgIcon.of("mark/star-full", 14);
  private static final SvgIcon OUTLINE = SvgIcon.of("mark/star", 14);

  private Star() {}

  /** The star of what is a favourite, or of what is not. */
  public static SvgIcon of(boolean favourite) {
    return favourite ? FULL : OUTLINE;
  }
}
