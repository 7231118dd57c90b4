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
  /** What an arm says of itself. */
  private static final class Said {
    final double[] positionRad = new double[Joints.COUNT];
    boolean rests = true;

    Said(Joints startRad) {
      startRad.copyTo(positionRad);
    }
  }

  private final List<Standing> arms;

  /** What each of the arms says, in their order; all see the same. */
  private final List<Said> said;

  private final int own;
  private final Said ownSaid;

  private ArmNeighbours(List<Standing> arms, List<Said> said, int own) {
    this.arms = arms;
    this.said = said;
    this.own = own;
    ownSaid = said.get(own);
  }

  /** What each of several arms sees, in their order. */
  static List<ArmNeighbours> of(List<Standing> arms) {
    List<Standing> standing = List.copyOf(arms);
    List<Said> said = standing.stream().map(arm -> new Said(arm.startRad())).toList();
    List<ArmNeighbours> all = new ArrayList<>();
    for (int i = 0; i < standing.size(); i++) {
      all.add(new ArmNeighbours(standing, said, i));
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
    System.arraycopy(positionRad, 0, ownSaid.positionRad, 0, Joints.COUNT);
    ownSaid.rests = rests;
  }

  /** How many numbers {@link #read} writes: six for each of the others. */
  public int numbers() {
    return Joints.COUNT * (arms.size() - 1);
  }

  /**
   * Where the others are.
   *
   * @param othersRad overwritten with six joint positions of each, in their order, rad
   */
  public void read(double[] othersRad) {
    int at = 0;
    for (int arm = 0; arm < arms.size(); arm++) {
      if (arm != own) {
        System.arraycopy(said.get(arm).positionRad, 0, othersRad, at, Joints.COUNT);
        at += Joints.COUNT;
      }
    }
  }

  /** Whether none of the others moves. */
  public boolean rest() {
    for (int arm = 0; arm < arms.size(); arm++) {
      if (arm != own && !said.get(arm).rests) {
        return false;
      }
    }
    return true;
  }

  /** What the links of this arm can get into, links of the others included. */
  public ArmSurroundings surroundings() {
    List<Standing> others = new ArrayList<>(arms);
    return new ArmSurroundings(others.remove(own), others);
  }
}
