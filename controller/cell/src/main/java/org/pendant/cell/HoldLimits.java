package org.pendant.cell;

/**
 * Hold limits: what a hold withstands. What is more slips.
 *
 * @param axis 0 to 2: the axis of the hold's frame that stands on the surface it holds
 * @param pullN along this axis, against its direction, N: what draws the body to the hold
 * @param pushN along this axis, N
 * @param shearN across it, N
 * @param torsionNm about it, Nm
 * @param bendNm about the others, Nm
 */
public record HoldLimits(
    int axis, double pullN, double pushN, double shearN, double torsionNm, double bendNm) {}
