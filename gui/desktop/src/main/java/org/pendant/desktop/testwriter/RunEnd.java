package org.pendant.desktop.testwriter;

import java.util.Optional;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/** Run end: how a run ended, as far as it is known. */
sealed interface RunEnd {
  /** In which frame, 0 for the one in which the program started. */
  long frame();

  /**
   * Where the arm stood.
   *
   * @param tcpInBase of the TCP that was active
   */
  record Place(Joints positionRad, Pose tcpInBase) {}

  /**
   * The program came to its end.
   *
   * @param place empty where the arm had not come to rest
   */
  record Finished(long frame, Optional<Place> place) implements RunEnd {}

  /** Somebody stopped it, as the last of the steps says. */
  record Stopped(long frame) implements RunEnd {}

  /**
   * It failed.
   *
   * @param message bytes, one {@code char} a byte
   */
  record Failed(long frame, String message) implements RunEnd {}

  /** The safety functions stopped the arm; what came later is not known here. */
  record Unsafe(long frame, String message) implements RunEnd {}

  /** It still ran, or its end was not recorded. */
  record Running(long frame) implements RunEnd {}
}
