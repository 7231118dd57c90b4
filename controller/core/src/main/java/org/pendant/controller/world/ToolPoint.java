package org.pendant.controller.world;

import org.pendant.models.json.Range;

/**
 * Tool point: a place of the tool that can touch things.
 *
 * @param pointInFlangeM where it is in the flange's frame, m, each -4 to 4
 * @param radiusM 0 to 1 m: above 0 the tool ends there in a ball of this radius around the point
 */
public record ToolPoint(Vector3 pointInFlangeM, double radiusM) {
  static final Range POINT = new Range(-4, 4, "m");
  static final Range RADIUS = new Range(0, 1, "m");

  /**
   * Checks the numbers.
   *
   * @throws IllegalArgumentException if one is outside its range
   */
  public ToolPoint {
    pointInFlangeM.require("point", POINT);
    RADIUS.require("radius", radiusM);
  }
}
