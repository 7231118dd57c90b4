package org.pendant.desktop.scene;

import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.mesh.Link;

/** Picked object: what the pointer is on. */
public sealed interface Picked {
  /** Where it is hit, in the base frame, m. */
  Vector3 pointInBaseM();

  /** How far from the eye, m. */
  double distanceM();

  /** A body of the arm. */
  record OnLink(Link link, Vector3 pointInBaseM, double distanceM) implements Picked {}

  /** Something that stands around the arm, by its name. */
  record OnObject(String name, Vector3 pointInBaseM, double distanceM) implements Picked {}

  /** The tool centre point, or near enough to be meant. */
  record OnTcp(Vector3 pointInBaseM, double distanceM) implements Picked {}
}
