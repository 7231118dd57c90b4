package org.pendant.desktop.scene;

import org.pendant.controller.world.Vector3;

/**
 * A ball in the base frame.
 *
 * @param centreM its centre, m
 * @param radiusM its radius, m
 */
public record Ball(Vector3 centreM, double radiusM) {

  /** The ball around the shoulder that the arm of a model can reach into. */
  public static Ball reach(SceneModel model) {
    return new Ball(new Vector3(0, 0, model.arm().dh().d1()), model.arm().reachM());
  }
}
