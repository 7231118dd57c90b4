package org.pendant.gui.shell;

import org.pendant.controller.world.Vector3;
import org.pendant.gui.move.ArmPull;
import org.pendant.gui.scene.view.ArmHand;

/** Hands what is dragged in the picture to what pulls the arm. */
record PullingHand(ArmPull pull) implements ArmHand {
  @Override
  public boolean grabs(boolean key) {
    return pull.grabs(key);
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
