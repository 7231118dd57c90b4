package org.pendant.desktop.scene;

import org.pendant.desktop.scene.mesh.Finish;

/** Scene theme: colours of the scene, as 0xRRGGBB. */
public enum SceneTheme {
  LIGHT(0xF3F5F8, 0xDDE3EA, 0xE9EDF1, 0x8D9AA8, 0x5E5138) {
    @Override
    public int rgb(Finish finish) {
      return switch (finish) {
        case SHELL -> 0xD3D7DB;
        case LID -> 0x4F7393;
        case SEAL -> 0x2B2F34;
        case METAL -> 0x9AA2AA;
        case OBJECT -> 0xB7A687;
        default -> common(finish);
      };
    }
  },
  DARK(0x23282E, 0x15181C, 0x262B31, 0x76828F, 0xD8C7A4) {
    @Override
    public int rgb(Finish finish) {
      return switch (finish) {
        case SHELL -> 0xBFC5CB;
        case LID -> 0x4E7697;
        case SEAL -> 0x1E2125;
        case METAL -> 0x848C94;
        case OBJECT -> 0x9A8A6C;
        default -> common(finish);
      };
    }
  };

  private final int top;
  private final int bottom;
  private final int floor;
  private final int grid;
  private final int edge;

  SceneTheme(int top, int bottom, int floor, int grid, int edge) {
    this.top = top;
    this.bottom = bottom;
    this.floor = floor;
    this.grid = grid;
    this.edge = edge;
  }

  /** Colour of a surface in white light. */
  public abstract int rgb(Finish finish);

  /** Behind everything, at the top of the picture. */
  public int topRgb() {
    return top;
  }

  /** Behind everything, at the bottom of the picture. */
  public int bottomRgb() {
    return bottom;
  }

  /** The floor between the lines of its grid. */
  public int floorRgb() {
    return floor;
  }

  /** The lines of the floor's grid. */
  public int gridRgb() {
    return grid;
  }

  /** The edges of boxes. */
  public int edgeRgb() {
    return edge;
  }

  private static int common(Finish finish) {
    return switch (finish) {
      case AXIS_X -> 0xD8433B;
      case AXIS_Y -> 0x3A9E4B;
      case AXIS_Z -> 0x3B73D9;
      case TOUCHED -> 0xE8762D;
      case TOOL -> 0x6B7580;
      case LOAD -> 0xC9971C;
      case SHELL, LID, SEAL, METAL, OBJECT ->
          throw new IllegalArgumentException(finish + " has a colour in each theme");
    };
  }
}
