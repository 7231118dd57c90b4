package org.pendant.motion.force;

/** Frame kind: how force mode reads its task frame (manual 15.12). */
public enum FrameKind {
  /** Type 1: y points from the TCP to the origin of the task frame. */
  POINT,
  /** Type 2: the task frame as it is. */
  FIXED,
  /** Type 3: x points where the path moves the TCP, seen along z of the task frame. */
  MOTION,
  /** The axes of the TCP, for screw driving (manual 15.43). */
  TOOL
}
