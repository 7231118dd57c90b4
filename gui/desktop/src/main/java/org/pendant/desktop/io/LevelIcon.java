package org.pendant.desktop.io;

import org.pendant.kit.icon.SvgIcon;

/** Level icon: high and low differ in shape, not only in colour. */
record LevelIcon(SvgIcon low, SvgIcon high) {
  private static final int HEIGHT = 18;
  private static final int SLIDE = 32;

  /** A slide that people move. */
  static final LevelIcon SWITCH = new LevelIcon("switch-low", "switch-high", SLIDE);

  /** A light that they only see. */
  static final LevelIcon LAMP = new LevelIcon("lamp-low", "lamp-high", HEIGHT);

  /** A slide whose high position is a demand to stop. */
  static final LevelIcon ALARM = new LevelIcon("switch-low", "alarm-high", SLIDE);

  private LevelIcon(String low, String high, int width) {
    this(drawing(low, width), drawing(high, width));
  }

  private static SvgIcon drawing(String name, int width) {
    return SvgIcon.of("signal/" + name, width, HEIGHT).lit();
  }

  SvgIcon of(boolean level) {
    return level ? high : low;
  }
}
