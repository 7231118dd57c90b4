package org.pendant.motion.offset;

import java.util.Optional;
import org.pendant.models.pose.Pose;
import org.pendant.motion.PathOffset;

/**
 * Conveyor tracking: the TCP moves along with a conveyor; what moves say is meant for the belt as
 * it stood when tracking began (manual 15.50, 15.56, 15.57). Neither the speed slider nor a pause
 * slows a belt down.
 *
 * <p>The manual does not say how a running belt is caught up with: here the tool speeds up as
 * {@code movel} does by default until it is where it has to be.
 */
public final class ConveyorTracking implements PathOffset {
  /** How strongly the tool speeds up to catch up with a belt, m/s². */
  public static final double ACCELERATION_M_PER_S2 = 1.2;

  /** How much faster than the belt the tool may be then, m/s. */
  public static final double CLOSING_M_PER_S = 0.25;

  private final CatchUp follower = new CatchUp();
  private Optional<Tracked> tracked = Optional.empty();

  private record Tracked(Belt belt, BeltPosition encoder, double startTicks, double travelPerTick) {
    double travel() {
      return (encoder.filteredTotal() - startTicks) * travelPerTick;
    }
  }

  /**
   * Tracks a straight conveyor from now on.
   *
   * @param directionInBase x, y and z are its direction, of any length above 0
   * @param ticksPerM what the encoder counts for each m, not 0
   * @return whether it does; not if another conveyor is being tracked
   */
  public boolean trackLinear(Pose directionInBase, double ticksPerM, BeltPosition encoder) {
    Belt belt = Belt.Linear.along(directionInBase.x(), directionInBase.y(), directionInBase.z());
    return track(belt, encoder, 1 / ticksPerM);
  }

  /**
   * Tracks a round conveyor from now on.
   *
   * @param centreInBase it turns about the z axis of this frame
   * @param ticksPerRevolution what the encoder counts for each turn, not 0
   * @param rotateTool whether the tool turns with it, or keeps its orientation
   * @return whether it does; not if another conveyor is being tracked
   */
  public boolean trackCircular(
      Pose centreInBase, double ticksPerRevolution, boolean rotateTool, BeltPosition encoder) {
    Belt belt = new Belt.Circular(centreInBase, rotateTool);
    return track(belt, encoder, 2 * Math.PI / ticksPerRevolution);
  }

  private boolean track(Belt belt, BeltPosition encoder, double travelPerTick) {
    if (active()) {
      return false;
    }
    tracked = Optional.of(new Tracked(belt, encoder, encoder.filteredTotal(), travelPerTick));
    follower.begin(0);
    return true;
  }

  @Override
  public boolean active() {
    return tracked.isPresent();
  }

  /** How far the tool has been carried, m or rad; 0 when no conveyor is tracked. */
  public double travel() {
    return active() ? follower.travel() : 0;
  }

  @Override
  public void apply(double[] tcpInBase) {
    Tracked now = tracked.orElseThrow();
    double reachM = now.belt().reachM(tcpInBase);
    follower.step(now.travel(), ACCELERATION_M_PER_S2 / reachM, CLOSING_M_PER_S / reachM);
    now.belt().carry(follower.travel(), tcpInBase);
  }

  @Override
  public void rest() {
    follower.rest();
  }

  @Override
  public void rebase(double[] tcpInBase, int framesAgo) {
    double travel = framesAgo == 0 ? follower.travel() : follower.travelBefore();
    tracked.orElseThrow().belt().carry(-travel, tcpInBase);
  }

  @Override
  public void end() {
    tracked = Optional.empty();
  }
}
