package org.pendant.desktop.shell;

import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.move.BodyPull;
import org.pendant.desktop.scene.DeviceHandles;
import org.pendant.desktop.scene.view.ObjectHand;

/**
 * Carrying hand: carries what has a mass when it is dragged in the picture, with the same key as
 * the arm is; on the screen Cell things are placed in the scene instead.
 */
final class CarryingHand implements ObjectHand {
  private final ObjectHand placing;
  private final BodyPull pull;
  private final BooleanSupplier past;
  private final BooleanSupplier wanted;
  private final Predicate<String> moves;
  private boolean carries;
  private Vector3 takenM = new Vector3(0, 0, 0);

  /**
   * @param placing what places objects on the screen Cell
   * @param past whether the picture shows the past, in which nothing can be carried
   * @param wanted whether no key is needed
   * @param moves whether an object of a name has a mass and is there
   */
  CarryingHand(
      ObjectHand placing,
      BodyPull pull,
      BooleanSupplier past,
      BooleanSupplier wanted,
      Predicate<String> moves) {
    this.placing = placing;
    this.pull = pull;
    this.past = past;
    this.wanted = wanted;
    this.moves = moves;
  }

  @Override
  public boolean grabs(boolean key) {
    return placing.grabs(key) || (!past.getAsBoolean() && (key || wanted.getAsBoolean()));
  }

  @Override
  public boolean hasHandles() {
    return placing.hasHandles();
  }

  @Override
  public boolean freely() {
    return carries;
  }

  @Override
  public boolean begin(String name, Vector3 pointInBaseM) {
    carries = !placing.grabs(false);
    if (!carries) {
      return placing.begin(name, pointInBaseM);
    }
    if (!moves.test(name)) {
      return false;
    }
    takenM = pointInBaseM;
    pull.begin(name, pointInBaseM);
    return true;
  }

  @Override
  public boolean begin(DeviceHandles.Handle handle) {
    carries = false;
    return placing.begin(handle);
  }

  @Override
  public void move(Vector3 wayInBaseM, boolean fine) {
    if (carries) {
      pull.move(
          new Vector3(
              takenM.x() + wayInBaseM.x(),
              takenM.y() + wayInBaseM.y(),
              takenM.z() + wayInBaseM.z()));
    } else {
      placing.move(wayInBaseM, fine);
    }
  }

  @Override
  public String words() {
    return carries ? "" : placing.words();
  }

  @Override
  public void end() {
    if (carries) {
      pull.end();
    } else {
      placing.end();
    }
  }
}
