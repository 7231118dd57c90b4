package org.pendant.motion;

/**
 * Tool curve: a smooth path of the TCP in the base frame, over a parameter of its own. Allocates
 * nothing.
 */
public interface ToolCurve {
  /**
   * The transformation (see {@link org.pendant.models.pose.Transforms}) at a point.
   *
   * @param at where on the curve
   * @param transform twelve numbers, overwritten
   */
  void at(double at, double[] transform);

  /**
   * The twist per unit of the parameter: derivative of the position, and the turning about the axes
   * of the base.
   *
   * @param twist six numbers, overwritten
   */
  void rate(double at, double[] twist);

  /** The derivative of {@link #rate} by the parameter. */
  void bend(double at, double[] twist);
}
