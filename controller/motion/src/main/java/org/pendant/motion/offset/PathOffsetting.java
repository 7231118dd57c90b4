package org.pendant.motion.offset;

import java.util.Arrays;
import org.pendant.models.pose.Pose;
import org.pendant.motion.PathOffset;

/**
 * Path offset that a program adds to the path of its moves (manual 15.34 to 15.39). Filter and
 * limits stay when it is disabled and enabled again.
 *
 * <p>The manual leaves open what an offset along the path is before the tool has moved: here there
 * is none until then.
 */
public final class PathOffsetting implements PathOffset {
  /** The largest shift along an axis at first, m. */
  public static final double DEFAULT_SHIFT_M = 0.1;

  /** The largest turn about an axis at first, rad. */
  public static final double DEFAULT_TURN_RAD = 0.52;

  private final MotionFrame along = new MotionFrame();
  private final OffsetFrames frames = new OffsetFrames(along);
  private final double[] wanted = new double[Pose.SIZE];
  private final double[] filtered = new double[Pose.SIZE];
  private boolean enabled;
  private OffsetType type = OffsetType.BASE;
  private double alpha = 1;
  private double mostShiftM = DEFAULT_SHIFT_M;
  private double mostTurnRad = DEFAULT_TURN_RAD;

  /** Begins to apply what has been and will be set. */
  public void enable() {
    if (!enabled) {
      enabled = true;
      Arrays.fill(filtered, 0);
      along.forget();
      frames.forget();
    }
  }

  /** Whether it is enabled. */
  @Override
  public boolean active() {
    return enabled;
  }

  /** Sets the offset; what is applied already continues from there in another frame. */
  public void set(Pose offset, OffsetType inFrame) {
    if (inFrame != type) {
      type = inFrame;
      frames.applied(type, filtered);
    }
    for (int i = 0; i < Pose.SIZE; i++) {
      wanted[i] = offset.get(i);
    }
  }

  /**
   * Sets how much of the way to the offset is gone in each frame.
   *
   * @param part 0 to 1; 1 for all of it, without a filter
   */
  public void setAlpha(double part) {
    alpha = part;
  }

  /** Sets how far the TCP may be shifted along each axis, m, and turned about it, rad. */
  public void setLimits(double shiftM, double turnRad) {
    mostShiftM = shiftM;
    mostTurnRad = turnRad;
  }

  /** A program starts: nothing has been set. */
  public void reset() {
    end();
    alpha = 1;
    setLimits(DEFAULT_SHIFT_M, DEFAULT_TURN_RAD);
    type = OffsetType.BASE;
  }

  /** The offset that is applied now, as it would be set in a frame. */
  public Pose applied(OffsetType inFrame) {
    double[] six = new double[Pose.SIZE];
    frames.applied(inFrame, six);
    return Pose.of(six);
  }

  @Override
  public void apply(double[] tcpInBase) {
    along.follow(tcpInBase);
    frames.begin(tcpInBase);
    if (type == OffsetType.MOTION && !along.known()) {
      return;
    }
    for (int i = 0; i < Pose.SIZE; i++) {
      double most = i < 3 ? mostShiftM : mostTurnRad;
      double within = Math.max(-most, Math.min(most, wanted[i]));
      filtered[i] = alpha * within + (1 - alpha) * filtered[i];
    }
    frames.lay(type, filtered, tcpInBase);
  }

  @Override
  public void end() {
    enabled = false;
    Arrays.fill(wanted, 0);
    Arrays.fill(filtered, 0);
    frames.forget();
  }
}
