package org.pendant.desktop.scene.mesh;

import org.pendant.models.shape.Tube;

/**
 * Limb radius: how thick the tube of a limb is. Its radius was taken at 30, 50 and 70 % of the
 * length; in between it changes smoothly, and towards the ends to what there is room for under the
 * lids.
 *
 * @param tube the measures
 * @param nearRoomM largest radius at the near end, m
 * @param farRoomM largest radius at the far end, m
 */
record LimbRadius(Tube tube, double nearRoomM, double farRoomM) implements Pipe.Radius {

  @Override
  public double atM(double share) {
    double measuredM =
        share < 0.5
            ? mix(tube.nearRadiusM(), tube.middleRadiusM(), (share - 0.3) / 0.2)
            : mix(tube.middleRadiusM(), tube.farRadiusM(), (share - 0.5) / 0.2);
    double nearM = mix(Math.min(measuredM, nearRoomM), measuredM, (share - 0.1) / 0.2);
    return mix(nearM, Math.min(nearM, farRoomM), (share - 0.7) / 0.2);
  }

  private static double mix(double from, double to, double t) {
    double part = Math.clamp(t, 0, 1);
    return from + (to - from) * part * part * (3 - 2 * part);
  }
}
