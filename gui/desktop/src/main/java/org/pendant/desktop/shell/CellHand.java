package org.pendant.desktop.shell;

import java.util.function.Supplier;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.DeviceHandles;
import org.pendant.desktop.scene.view.ObjectHand;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;

/**
 * Cell hand: has a hand that works in the frame of the cell drag in a picture that is in the frame
 * of an arm's base.
 */
final class CellHand implements ObjectHand {
  /** Less than this comes of rounding when frames are turned. */
  private static final double NOTHING_M = 1e-9;

  private final ObjectHand hand;
  private final Supplier<Pose> baseInCell;

  CellHand(ObjectHand hand, Supplier<Pose> baseInCell) {
    this.hand = hand;
    this.baseInCell = baseInCell;
  }

  @Override
  public boolean grabs(boolean key) {
    return hand.grabs(key);
  }

  @Override
  public boolean hasHandles() {
    return hand.hasHandles();
  }

  @Override
  public boolean freely() {
    return hand.freely();
  }

  @Override
  public boolean begin(String name, Vector3 pointInBaseM) {
    return hand.begin(name, inCell(pointInBaseM, baseInCell.get()));
  }

  @Override
  public boolean begin(DeviceHandles.Handle handle) {
    return hand.begin(
        new DeviceHandles.Handle(
            handle.device(), handle.key(), inCell(handle.placeM(), baseInCell.get())));
  }

  @Override
  public void move(Vector3 wayInBaseM, boolean fine) {
    Pose base = baseInCell.get();
    Vector3 wayM = inCell(wayInBaseM, new Pose(0, 0, 0, base.rx(), base.ry(), base.rz()));
    hand.move(new Vector3(step(wayM.x()), step(wayM.y()), step(wayM.z())), fine);
  }

  /** What does not go along an axis of the cell keeps its place there. */
  private static double step(double wayM) {
    return Math.abs(wayM) < NOTHING_M ? 0 : wayM;
  }

  private static Vector3 inCell(Vector3 inBaseM, Pose base) {
    if (base.equals(Pose.ZERO)) {
      return inBaseM;
    }
    Pose at = Poses.trans(base, new Pose(inBaseM.x(), inBaseM.y(), inBaseM.z(), 0, 0, 0));
    return new Vector3(at.x(), at.y(), at.z());
  }

  @Override
  public String words() {
    return hand.words();
  }

  @Override
  public void end() {
    hand.end();
  }
}
