package org.pendant.project.program;

/** Move kind: the sort of path that a {@link MotionStep.Move} takes. */
public enum MoveKind {
  /** Each joint goes its own way: {@code movej}. */
  JOINT,
  /** The tool goes along a line: {@code movel}. */
  LINEAR,
  /** The tool goes along a line at constant speed, with round corners: {@code movep}. */
  PROCESS
}
