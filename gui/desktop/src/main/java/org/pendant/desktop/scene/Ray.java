package org.pendant.desktop.scene;

import org.pendant.controller.world.Vector3;

/**
 * Ray: half a line in the base frame.
 *
 * @param fromM where it begins, m
 * @param direction where it goes, of length 1
 */
public record Ray(Vector3 fromM, Vector3 direction) {

  /** The point at a distance from the beginning, m. */
  public Vector3 pointM(double distanceM) {
    return new Vector3(
        fromM.x() + distanceM * direction.x(),
        fromM.y() + distanceM * direction.y(),
        fromM.z() + distanceM * direction.z());
  }
}
