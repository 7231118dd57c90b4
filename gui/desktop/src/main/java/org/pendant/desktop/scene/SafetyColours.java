package org.pendant.desktop.scene;

import org.pendant.controller.safety.Applies;
import org.pendant.desktop.scene.SafetySight.State;

/** Safety colours: of what bounds the arm, as 0xRRGGBB, and how well it can be seen through. */
public final class SafetyColours {
  private static final int TRIPPED_LIGHT = 0xCC2222;
  private static final int TRIPPED_DARK = 0xFF5A50;

  private SafetyColours() {}

  /** The colour of what applies so, in this state. */
  static int rgb(Applies applies, State state, SceneTheme theme) {
    boolean light = theme == SceneTheme.LIGHT;
    if (state == State.TRIPPED) {
      return light ? TRIPPED_LIGHT : TRIPPED_DARK;
    }
    if (state == State.PROPOSED) {
      return light ? 0x8A3FA8 : 0xD59BEF;
    }
    return switch (applies) {
      case BOTH -> light ? 0x1F8A78 : 0x4FC9B2;
      case NORMAL -> light ? 0x2F74C0 : 0x6FB1F5;
      case REDUCED -> light ? 0xA9740B : 0xE8B54A;
      case TRIGGERS_REDUCED -> light ? 0x7A6A00 : 0xD6CF5A;
    };
  }

  /** The colour of limits that are no part of the configuration's planes. */
  public static int forbiddenRgb(SceneTheme theme) {
    return theme == SceneTheme.LIGHT ? TRIPPED_LIGHT : TRIPPED_DARK;
  }

  /** How much of the background a surface covers. */
  static float opacity(State state) {
    return switch (state) {
      case HOLDS -> 0.16f;
      case WAITS -> 0.05f;
      case PROPOSED -> 0.12f;
      case TRIPPED -> 0.38f;
    };
  }

  /** Whether lines are broken: nothing holds there now. */
  static boolean dashed(State state) {
    return state == State.WAITS || state == State.PROPOSED;
  }
}
