package org.pendant.motion.offset;

/** Where a conveyor belt is, as its encoder says (manual 15.54 to 15.56). */
public interface BeltPosition {
  /** Ticks that have gone by, filtered and without any wrapping. */
  double filteredTotal();
}
