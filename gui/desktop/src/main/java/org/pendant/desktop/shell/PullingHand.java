package org.pendant.desktop.shell;

import java.util.function.BooleanSupplier;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.move.ArmPull;
import org.pendant.desktop.scene.view.ArmHand;

/**
 * Pulling hand: hands what is dragged in the picture to what pulls the arm.
 *
 * @param past whether the picture shows the past, in which nothing can be pulled
 */
record PullingHand(ArmPull pull, BooleanSupplier past) implements ArmHand {
  @Override
  public boolean grabs(boolean key) {
    return !past.getAsBoolean() && pull.grabs(key);
  }

  @Override
  public void begin(int link, Vector3 pointInLinkM, Vector3 placeInBaseM) {
    pull.begin(link, pointInLinkM, placeInBaseM);
  }

  @Override
  public void move(Vector3 placeInBaseM) {
    pull.move(placeInBaseM);
  }

  @Override
  public void end() {
    pull.end();
  }

  @Override
  public boolean pulls() {
    return pull.pulls();
  }
}
