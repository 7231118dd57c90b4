package org.pendant.motion.toolpath;

import org.pendant.models.pose.Pose;
import org.pendant.motion.toolpath.nc.NcPath;

/** Queued motion of a toolpath, its poses in the work frame. */
sealed interface QueuedMotion {

  /** How fast, and how its end may be cut. */
  Leg.Limits pace();

  /** A straight line (manual 20.3). */
  record Line(Pose to, Leg.Limits pace) implements QueuedMotion {}

  /**
   * An arc (manual 20.2).
   *
   * @param via of which only the position counts
   * @param withTangent whether the tool keeps its orientation to the tangent
   */
  record Arc(Pose via, Pose to, boolean withTangent, Leg.Limits pace) implements QueuedMotion {}

  /**
   * A toolpath from a file (manual 20.4).
   *
   * @param pcs the part in the work frame
   * @param feeds whether the feed rates of the file count instead of the speed
   */
  record Path(NcPath path, Pose pcs, boolean feeds, Leg.Limits pace) implements QueuedMotion {}
}
