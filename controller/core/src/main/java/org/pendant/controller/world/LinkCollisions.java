package org.pendant.controller.world;

import java.util.Arrays;
import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.pose.Pose;

/**
 * Link collisions: notices when a link of the arm gets into another one, into an object of the
 * scene, or into a link of another arm.
 *
 * <p>What is in something at first may be so, until it has left it: an arm may be mounted in a hole
 * of a table. What has got in is told, and told again for each millimetre that it gets deeper; it
 * may leave.
 *
 * <p>Allocates nothing but what it tells, and looks again only after the arm could have travelled
 * as far as something is away. Belongs to the thread of the frame loop.
 */
public final class LinkCollisions {
  /** How much deeper than it has been something may get before that is told again, m. */
  private static final double MARGIN_M = 1e-3;

  /** What is in something is looked at again after so much travel, m. */
  private static final double LOOK_M = 5e-4;

  private final LinkPairs all;

  /** For each pair how deep it may be, m: 0 mostly, infinite until what was in has left. */
  private final double[] allowedM;

  private double slackM;

  /**
   * Whether the tool is the flange: then it is wrist 3 that presses, and objects do not stop it.
   */
  private boolean bareFlange;

  LinkCollisions(LinkPairs all) {
    this.all = all;
    bareFlange = all.bareFlange(Pose.ZERO);
    allowedM = new double[all.pairs()];
    restart();
  }

  /**
   * The collisions of an arm in a scene; empty where links pass through all there is, also where
   * there is nothing at all.
   */
  public static Optional<LinkCollisions> of(ArmDescription arm, Scene scene) {
    if (scene.links() == LinkContact.PASS || scene.equals(Scene.EMPTY)) {
      return Optional.empty();
    }
    ArmSurroundings surroundings = new ArmSurroundings(arm, scene);
    return surroundings.pairs() > 0
        ? Optional.of(new LinkCollisions(surroundings))
        : Optional.empty();
  }

  /** The arm has been put elsewhere: what it is in there it may be in. */
  public void restart() {
    Arrays.fill(allowedM, Double.POSITIVE_INFINITY);
    slackM = -1;
  }

  /** Says where the tool touches things, unless the scene does. */
  public void setTool(Pose tcpInFlange) {
    boolean bare = all.bareFlange(tcpInFlange);
    if (bare != bareFlange) {
      bareFlange = bare;
      slackM = -1;
    }
  }

  /**
   * Looks at the arm.
   *
   * @param positionRad six joint positions, rad
   * @param tolerated whether it may get into things now, since nothing drives it or it is stopping
   * @return what it has got into, the deepest; empty in most frames
   */
  public Optional<LinkHit> look(double[] positionRad, boolean tolerated) {
    if (all.travelM(positionRad) < slackM) {
      return Optional.empty();
    }
    all.at(positionRad);
    slackM = Double.POSITIVE_INFINITY;
    int deepest = -1;
    double deepestM = 0;
    for (int pair = 0; pair < allowedM.length; pair++) {
      if (bareFlange && all.presses(pair)) {
        allowedM[pair] = Double.POSITIVE_INFINITY;
        continue;
      }
      double depthM = depthM(pair);
      if (depthM <= allowedM[pair]) {
        continue;
      }
      allowedM[pair] = depthM + MARGIN_M;
      slackM = Math.min(slackM, LOOK_M);
      if (!tolerated && depthM > deepestM) {
        deepest = pair;
        deepestM = depthM;
      }
    }
    return deepest < 0 ? Optional.empty() : Optional.of(all.hit(deepest, deepestM));
  }

  /** How deep a pair is; takes back what it is allowed, and how far the arm may travel unseen. */
  private double depthM(int pair) {
    double allowed = allowedM[pair];
    double distanceM = all.distanceM(pair, allowed > 0 ? MARGIN_M : slackM);
    if (distanceM >= MARGIN_M || allowed == 0) {
      allowedM[pair] = 0;
      slackM = Math.min(slackM, Math.max(0, distanceM));
    } else if (allowed == Double.POSITIVE_INFINITY) {
      slackM = Math.min(slackM, LOOK_M);
    } else {
      allowedM[pair] = Math.min(allowed, Math.max(0, -distanceM) + MARGIN_M);
      double leftM = Math.max(0, allowedM[pair] + distanceM);
      slackM = Math.min(slackM, Math.min(LOOK_M, leftM));
    }
    return -distanceM;
  }
}
