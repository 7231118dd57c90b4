package org.pendant.controller.world;

import java.util.ArrayList;
import java.util.List;
import org.pendant.controller.world.CellWorld.Standing;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/**
 * Arm neighbours: the other arms of a cell, as one of the arms sees them. Each says at the end of
 * its frame where its joints are, as its encoders read them; so those that come earlier in the file
 * are where they are in this frame, those that come later where they were in the one before.
 *
 * <p>Belongs to the thread that drives the cell.
 */
public final class ArmNeighbours {
  /** What all arms of a cell write, six positions of joints each, rad. */
  private record Shared(List<Standing> arms, List<double[]> positionsRad, List<Boolean> rests) {}

  private final Shared shared;
  private final int own;

  private ArmNeighbours(Shared shared, int own) {
    this.shared = shared;
    this.own = own;
  }

  /** What each of several arms sees, in their order. */
  static List<ArmNeighbours> of(List<Standing> arms) {
    List<double[]> positionsRad = new ArrayList<>();
    List<Boolean> rests = new ArrayList<>();
    for (Standing arm : arms) {
      double[] q = new double[Joints.COUNT];
      arm.startRad().copyTo(q);
      positionsRad.add(q);
      rests.add(true);
    }
    Shared shared = new Shared(List.copyOf(arms), positionsRad, rests);
    List<ArmNeighbours> all = new ArrayList<>();
    for (int i = 0; i < arms.size(); i++) {
      all.add(new ArmNeighbours(shared, i));
    }
    return all;
  }

  /** What an arm sees that has no neighbours. */
  public static ArmNeighbours alone(ArmDescription arm, Scene scene) {
    return of(List.of(new Standing("", arm, scene, Joints.ZERO, Pose.ZERO, true))).getFirst();
  }

  /**
   * Says where this arm is.
   *
   * @param positionRad six joint positions, rad
   * @param rests whether it moves no more than its encoders err
   */
  public void say(double[] positionRad, boolean rests) {
    System.arraycopy(positionRad, 0, shared.positionsRad.get(own), 0, Joints.COUNT);
    shared.rests.set(own, rests);
  }

  /** How many numbers {@link #read} writes: six for each of the others. */
  public int numbers() {
    return Joints.COUNT * (shared.arms.size() - 1);
  }

  /**
   * Where the others are.
   *
   * @param othersRad overwritten with six joint positions of each, in their order, rad
   */
  public void read(double[] othersRad) {
    int at = 0;
    for (int arm = 0; arm < shared.arms.size(); arm++) {
      if (arm != own) {
        System.arraycopy(shared.positionsRad.get(arm), 0, othersRad, at, Joints.COUNT);
        at += Joints.COUNT;
      }
    }
  }

  /** Whether none of the others moves. */
  public boolean rest() {
    for (int arm = 0; arm < shared.arms.size(); arm++) {
      if (arm != own && !shared.rests.get(arm)) {
        return false;
      }
    }
    return true;
  }

  /** What the links of this arm can get into, links of the others included. */
  public ArmSurroundings surroundings() {
    List<Standing> others = new ArrayList<>(shared.arms);
    return new ArmSurroundings(others.remove(own), others);
  }
}
