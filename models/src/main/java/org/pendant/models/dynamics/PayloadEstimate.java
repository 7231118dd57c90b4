package org.pendant.models.dynamics;

import static org.pendant.models.dynamics.DynamicsTexts.text;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.pose.Wrench;

/**
 * Payload estimate: mass and centre of gravity of what is mounted on the flange, from how its
 * weight loads the flange in several orientations (manual 16.2).
 *
 * <p>With a the acceleration that the resting arm feels, R the rotation of the flange, m the mass
 * and h = m c the first moment of the load, each measurement says {@code f = -m a + R b} and {@code
 * t = a x (R h) + R d}. The sensor's zero (b, d), constant along the axes of the flange, is found
 * along with the load, so it does not matter what hung there when the sensor was zeroed. Both
 * systems are linear; they are solved by least squares.
 */
public sealed interface PayloadEstimate {
  /** Fewest measurements that are accepted. */
  int MIN_POSES = 4;

  /** Most measurements that are accepted: every pose is compared with every other. */
  int MAX_POSES = 500;

  /** A load of less than this, kg, counts as none: its centre of gravity would be noise. */
  double MIN_MASS_KG = 0.01;

  /**
   * A point mass at the centre of gravity of the load, or {@link Payload#NONE} for less than {@link
   * #MIN_MASS_KG}.
   */
  record Found(Payload payload) implements PayloadEstimate {}

  /**
   * The measurements do not tell.
   *
   * @param reason what is wrong with them, as part of a sentence
   */
  record Refused(String reason) implements PayloadEstimate {}

  /**
   * Estimates the load of a resting arm.
   *
   * @param flangesInBase where the flange was; only the orientation matters
   * @param wrenchesInBase load on the flange at each of these poses, at the flange's origin along
   *     the axes of the base, finite, N and Nm
   * @param gravityX acceleration that the resting arm feels along the axes of the base, m/s²
   * @param gravityY see {@code gravityX}
   * @param gravityZ see {@code gravityX}
   */
  static PayloadEstimate of(
      List<Pose> flangesInBase,
      List<Wrench> wrenchesInBase,
      double gravityX,
      double gravityY,
      double gravityZ) {
    int count = flangesInBase.size();
    if (count != wrenchesInBase.size()) {
      return new Refused(text("otherCount", count, wrenchesInBase.size()));
    }
    if (count < MIN_POSES || count > MAX_POSES) {
      return new Refused(text("poseCount", count, MIN_POSES, MAX_POSES));
    }
    Optional<String> tooClose = tooClose(flangesInBase, Math.PI / (2 * count));
    if (tooClose.isPresent()) {
      return new Refused(tooClose.get());
    }
    return new PayloadEquations(flangesInBase, wrenchesInBase, gravityX, gravityY, gravityZ)
        .solve();
  }

  private static Optional<String> tooClose(List<Pose> poses, double leastRad) {
    for (int i = 0; i < poses.size(); i++) {
      for (int k = i + 1; k < poses.size(); k++) {
        double apartRad = Poses.rotationAngle(poses.get(i), poses.get(k));
        if (!(apartRad >= leastRad)) {
          return Optional.of(
              DynamicsTexts.text(
                  "tooClose",
                  i,
                  k,
                  String.format(Locale.ROOT, "%.4f", apartRad),
                  String.format(Locale.ROOT, "%.4f", leastRad),
                  poses.size()));
        }
      }
    }
    return Optional.empty();
  }
}
