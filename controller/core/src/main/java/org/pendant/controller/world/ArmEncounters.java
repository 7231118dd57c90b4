package org.pendant.controller.world;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.world.CellWorld.Standing;
import org.pendant.models.arm.Joints;
import org.pendant.models.collision.LinkCapsules;
import org.pendant.models.collision.PlacedLinks;
import org.pendant.models.pose.Pose;

/**
 * Arm encounters: what the links of an arm can get into of the other arms in its cell. Each arm
 * looks for itself. Two bases do not meet, as neither moves.
 */
final class ArmEncounters implements LinkPairs {
  /**
   * An arm of the cell.
   *
   * @param name what messages call it by
   */
  record Neighbour(String name, PlacedLinks links) {}

  /** A body of this arm and one of another. */
  private record Encounter(int body, Neighbour other, int otherBody) {}

  private final PlacedLinks own;
  private final List<Neighbour> others;
  private final double[] q = new double[Joints.COUNT];
  private final List<Encounter> encounters = new ArrayList<>();
  private double travelledM;

  ArmEncounters(PlacedLinks own, List<Neighbour> others) {
    this.own = own;
    this.others = List.copyOf(others);
    for (Neighbour other : others) {
      for (int body = 0; body < LinkCapsules.BODIES; body++) {
        for (int of = 0; own.has(body) && of < LinkCapsules.BODIES; of++) {
          boolean move = body != LinkCapsules.BASE || of != LinkCapsules.BASE;
          if (move && other.links().has(of)) {
            encounters.add(new Encounter(body, other, of));
          }
        }
      }
    }
  }

  /** An arm where it stands, with its joints where they are at first. */
  static Neighbour neighbour(Standing arm) {
    PlacedLinks links =
        new PlacedLinks(
            arm.arm(),
            ArmSurroundings.capsules(arm.arm(), arm.scene().toolPoints()),
            ToolBody.solids(arm.scene().toolBodies()),
            arm.baseInCell());
    double[] q = new double[Joints.COUNT];
    arm.startRad().copyTo(q);
    links.at(q);
    return new Neighbour(arm.name(), links);
  }

  /**
   * Moves the others, unless they do so themselves.
   *
   * @param othersRad six joint positions of each, in their order, rad
   */
  void moveOthers(double[] othersRad) {
    for (int i = 0; i < others.size(); i++) {
      System.arraycopy(othersRad, Joints.COUNT * i, q, 0, Joints.COUNT);
      others.get(i).links().at(q);
    }
  }

  @Override
  public int pairs() {
    return encounters.size();
  }

  @Override
  public void at(double[] positionRad) {
    own.at(positionRad);
    travelledM = travelledTogetherM();
  }

  @Override
  public double travelM(double[] positionRad) {
    own.at(positionRad);
    return travelledTogetherM() - travelledM;
  }

  private double travelledTogetherM() {
    double sumM = own.travelledM();
    for (int i = 0; i < others.size(); i++) {
      sumM += others.get(i).links().travelledM();
    }
    return sumM;
  }

  @Override
  public double distanceM(int pair, double farM) {
    Encounter of = encounters.get(pair);
    return own.apartM(of.body(), of.other().links(), of.otherBody(), farM);
  }

  @Override
  public boolean bareFlange(Pose tcpInFlange) {
    return false;
  }

  @Override
  public boolean presses(int pair) {
    return false;
  }

  @Override
  public LinkHit hit(int pair, double depthM) {
    Encounter of = encounters.get(pair);
    return new LinkHit(
        LinkCapsules.name(of.body()),
        LinkCapsules.name(of.otherBody()),
        false,
        Optional.of(of.other().name()),
        ArmSurroundings.jointOf(of.body()),
        depthM);
  }
}
