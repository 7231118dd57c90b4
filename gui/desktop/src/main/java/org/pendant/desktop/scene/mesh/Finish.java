package org.pendant.desktop.scene.mesh;

/** Finish: what a surface looks like; the theme says which colour that is. */
public enum Finish {
  /** Painted castings and tubes of the arm. */
  SHELL(0),
  /** Covers over the joints. */
  LID(1),
  /** Rubber between two links, screws. */
  SEAL(2),
  /** Bare metal: foot and flange. */
  METAL(3),
  /** The x axis of a frame. */
  AXIS_X(4),
  /** The y axis of a frame. */
  AXIS_Y(5),
  /** The z axis of a frame. */
  AXIS_Z(6),
  /** Something that stands around the arm. */
  OBJECT(7),
  /** The same while the tool touches it. */
  TOUCHED(8),
  /** The rod from the flange to the tool centre point. */
  TOOL(9),
  /** The ball that stands for what hangs on the flange. */
  LOAD(10);

  private final int number;

  Finish(int number) {
    this.number = number;
  }

  /** Its number in vertices, from 0 without gaps. */
  public int number() {
    return number;
  }
}
