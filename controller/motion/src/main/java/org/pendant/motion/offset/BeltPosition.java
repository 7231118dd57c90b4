package org.pendant.motion.offset;

/** Belt position as the conveyor's encoder reports it (manual 15.54 to 15.56). */
public interface BeltPosition {
  /** Ticks that have gone by, filtered and without any wrapping. */
  double filteredTotal();
}
