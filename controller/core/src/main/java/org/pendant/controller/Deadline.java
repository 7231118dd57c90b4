package org.pendant.controller;

import java.time.Duration;

/**
 * Deadline of a command, counted from when it is asked for. A frame takes 2 ms, and while robot
 * time stands commands are carried out at once: who gets no reply for much longer speaks to a
 * controller that no thread drives.
 *
 * @param afterNs how long to wait at most, ns
 * @param late whether the command is carried out even after that; otherwise it is taken back
 */
public record Deadline(long afterNs, boolean late) {
  /** Waits until the reply comes; when there is no place among the commands it does not wait. */
  public static final Deadline NONE = new Deadline(Long.MAX_VALUE, true);

  /** How long to wait for a place among the commands at most, ns. */
  long placeNs() {
    return afterNs == Long.MAX_VALUE ? 0 : afterNs;
  }

  /** What is not carried out by then is never carried out. */
  public static Deadline orNever(Duration after) {
    return new Deadline(after.toNanos(), false);
  }

  /** What is not carried out by then is carried out later. */
  public static Deadline orLater(Duration after) {
    return new Deadline(after.toNanos(), true);
  }
}
