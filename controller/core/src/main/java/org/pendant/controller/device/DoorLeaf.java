package org.pendant.controller.device;

import org.pendant.cell.BodyHinge;
import org.pendant.cell.BodyRail;

/**
 * Door leaf: the object of the scene that a door moves, from where it is at first, open, to shut.
 */
public sealed interface DoorLeaf {
  /** Name of the object. */
  String object();

  /** How far it goes: m, or rad where it turns. */
  double travel();

  /** It is at an end when it is so near, m or rad. */
  double atEnd();

  /**
   * One that slides.
   *
   * @param line in the frame of the cell, towards where it is shut; its friction is what drives it
   */
  record Slide(String object, BodyRail.Line line) implements DoorLeaf {
    @Override
    public double travel() {
      return line.travelM();
    }

    @Override
    public double atEnd() {
      return 0.001;
    }
  }

  /**
   * One that turns.
   *
   * @param axis in the frame of the cell, right-handed towards where it is shut; its friction is
   *     what drives it
   */
  record Turn(String object, BodyHinge.Axis axis) implements DoorLeaf {
    @Override
    public double travel() {
      return axis.angleRad();
    }

    @Override
    public double atEnd() {
      return 0.005;
    }
  }
}
