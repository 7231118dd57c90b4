package org.pendant.sweep.plan;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.pendant.models.pose.Pose;

/** Frame axis: one of the six ways in which something is displaced. */
public enum FrameAxis {
  /** Along x of the base, m. */
  X,
  /** Along y of the base, m. */
  Y,
  /** Along z of the base, m. */
  Z,
  /** About an axis like x of the base, rad. */
  RX,
  /** About an axis like y of the base, rad. */
  RY,
  /** About an axis like z of the base, rad. */
  RZ;

  /** As plans write it. */
  public String word() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** The axis of a word. */
  public static Optional<FrameAxis> of(String word) {
    return Arrays.stream(values()).filter(each -> each.word().equals(word)).findFirst();
  }

  /** All words. */
  public static List<String> words() {
    return Arrays.stream(values()).map(FrameAxis::word).toList();
  }

  /** A displacement by so much along or about this axis alone, m or rad. */
  public Pose displacement(double amount) {
    return Pose.ZERO.with(ordinal(), amount);
  }
}
