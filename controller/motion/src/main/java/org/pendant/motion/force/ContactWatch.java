package org.pendant.motion.force;

import org.pendant.models.pose.WrenchNumbers;

/**
 * Contact detector: notices that the force on the tool changes, and when that began (manual 16.66).
 * What counts is the difference from a slow mean of the force, so that a payload that is declared
 * wrongly is no contact.
 */
public final class ContactWatch {
  /** Frames that are looked back at, the newest included; as many as positions are kept for. */
  public static final int FRAMES = 1000;

  /** Change of force that is a contact unless a program says otherwise, N; our choice. */
  public static final double THRESHOLD_N = 5;

  /** From this change on a contact has begun, N. */
  private static final double ONSET_N = 0.5;

  /** Share of a change that the mean takes over in a frame: in 2 s, and 20 s during a contact. */
  private static final double SHARE = 0.001;

  private static final double SHARE_IN_CONTACT = 0.0001;

  private final double[] x = new double[FRAMES];
  private final double[] y = new double[FRAMES];
  private final double[] z = new double[FRAMES];
  private double meanX;
  private double meanY;
  private double meanZ;
  private int newest;

  /** Frames that count: those since the sensor has had another zero. */
  private int known;

  /** The frames so far do not compare with those that come. */
  public void forget() {
    known = 0;
  }

  /**
   * A frame is over.
   *
   * @param flangeWrenchInBase what has acted on the tool from outside
   */
  public void add(WrenchNumbers flangeWrenchInBase) {
    if (known == 0) {
      meanX = flangeWrenchInBase.get(0);
      meanY = flangeWrenchInBase.get(1);
      meanZ = flangeWrenchInBase.get(2);
    }
    newest = (newest + 1) % FRAMES;
    known = Math.min(known + 1, FRAMES);
    x[newest] = flangeWrenchInBase.get(0) - meanX;
    y[newest] = flangeWrenchInBase.get(1) - meanY;
    z[newest] = flangeWrenchInBase.get(2) - meanZ;
    double share = changeN() > THRESHOLD_N ? SHARE_IN_CONTACT : SHARE;
    meanX += share * x[newest];
    meanY += share * y[newest];
    meanZ += share * z[newest];
  }

  private double changeN() {
    return Math.sqrt(x[newest] * x[newest] + y[newest] * y[newest] + z[newest] * z[newest]);
  }

  /**
   * How many frames ago the tool was just not in contact yet; 0 if it is in none.
   *
   * @param direction3 where the tool goes, along the axes of the base, of any length; contacts from
   *     everywhere count if it is 0
   * @param thresholdN change of force that is a contact, above 0
   */
  public int framesSinceOnset(double[] direction3, double thresholdN) {
    if (known == 0) {
      return 0;
    }
    double length = length(direction3[0], direction3[1], direction3[2]);
    double change = changeN();
    if (length == 0 && change == 0) {
      return 0;
    }
    // the surface pushes back: against the direction, or whichever way it does now
    double ux = length > 0 ? -direction3[0] / length : x[newest] / change;
    double uy = length > 0 ? -direction3[1] / length : y[newest] / change;
    double uz = length > 0 ? -direction3[2] / length : z[newest] / change;
    if (along(0, ux, uy, uz) <= thresholdN) {
      return 0;
    }
    int ago = 1;
    while (ago < known - 1 && along(ago, ux, uy, uz) > ONSET_N) {
      ago++;
    }
    return ago;
  }

  private double along(int ago, double ux, double uy, double uz) {
    int at = Math.floorMod(newest - ago, FRAMES);
    return ux * x[at] + uy * y[at] + uz * z[at];
  }

  private static double length(double x, double y, double z) {
    return Math.sqrt(x * x + y * y + z * z);
  }
}
