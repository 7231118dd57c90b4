package org.pendant.desktop.scene.mesh;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.joml.Matrix4f;
import org.joml.Vector3f;

/**
 * Tubing: the skin of a tube that grows out of a barrel at its far end, and of another or of none
 * at its near end. It is laid in staves: lines from end to end, one at each angle.
 */
final class Tubing {
  private static final int FILLET_STEPS = 7;

  /** The radius of limbs changes on the way, that of necks does not. */
  private static final int STEPS_OF_LIMB = 8;

  private static final int STEPS_OF_NECK = 2;
  private static final int BEVEL_STEPS = 3;

  /** Rounding of a free end, m. */
  static final double BEVEL_M = 0.0012;

  /** The skin ends this far inside the barrel, so that no light comes through. */
  private static final float SUNK_M = 6e-4f;

  private static final double MIN_FILLET_M = 8e-4;

  private final Pipe pipe;
  private final Optional<Barrel> near;
  private final Barrel far;
  private final double filletM;
  private final Detail detail;

  private record Knot(Vector3f point, Vector3f normal) {}

  /**
   * @param pipe from the middle of the near barrel, or the free end, to the middle of the far one
   * @param filletM size of the fillets where there is room for them, m
   * @param detail how finely it is cut
   */
  Tubing(Pipe pipe, Optional<Barrel> near, Barrel far, double filletM, Detail detail) {
    this.pipe = pipe;
    this.near = near;
    this.far = far;
    this.filletM = filletM;
    this.detail = detail;
  }

  void addTo(MeshBuilder mesh) {
    List<List<Knot>> staves = new ArrayList<>();
    int around = detail.around(Lathe.AROUND);
    for (int j = 0; j < around; j++) {
      staves.add(stave(2 * Math.PI * j / around));
    }
    mesh.at(new Matrix4f()).finish(Finish.SHELL);
    int rings = staves.getFirst().size();
    int first = -1;
    for (int ring = 0; ring < rings; ring++) {
      for (List<Knot> stave : staves) {
        Vector3f p = stave.get(ring).point;
        Vector3f n = stave.get(ring).normal;
        int vertex = mesh.vertex(p.x, p.y, p.z, n.x, n.y, n.z);
        first = first < 0 ? vertex : first;
      }
    }
    mesh.skin(first, rings, around);
  }

  private List<Knot> stave(double angleRad) {
    double lengthM = pipe.lengthM();
    double entersFarM = enters(far, angleRad, lengthM);
    List<Knot> knots = new ArrayList<>();
    double startM;
    double roomM;
    if (near.isPresent()) {
      double entersNearM = enters(near.get(), angleRad, 0);
      roomM = (entersFarM - entersNearM) / 2;
      double sizeM = sizeM(near.get(), angleRad, entersNearM, roomM);
      startM = entersNearM + sizeM;
      List<Knot> fillet = fillet(near.get(), angleRad, entersNearM, startM, sizeM);
      Vector3f inwards = pipe.direction(0, 0, -1);
      knots.add(new Knot(pipe.point(0, 0, 0), inwards));
      knots.add(new Knot(fillet.getLast().point, inwards));
      knots.addAll(fillet.reversed());
    } else {
      startM = BEVEL_M;
      roomM = entersFarM - startM;
      addFreeEnd(angleRad, knots);
    }
    double sizeM = sizeM(far, angleRad, entersFarM, roomM);
    double endM = entersFarM - sizeM;
    int steps = detail.steps(near.isPresent() ? STEPS_OF_LIMB : STEPS_OF_NECK);
    for (int i = 1; i < steps; i++) {
      double z = startM + (endM - startM) * i / steps;
      knots.add(new Knot(pipe.point(angleRad, pipe.radiusM(z), z), pipe.normal(angleRad, z)));
    }
    knots.addAll(fillet(far, angleRad, entersFarM, endM, sizeM));
    Vector3f inwards = pipe.direction(0, 0, 1);
    knots.add(new Knot(knots.getLast().point, inwards));
    knots.add(new Knot(pipe.point(0, 0, lengthM), inwards));
    return knots;
  }

  private void addFreeEnd(double angleRad, List<Knot> knots) {
    double r = pipe.radiusM(0);
    knots.add(new Knot(pipe.point(0, 0, 0), pipe.direction(0, 0, -1)));
    int steps = detail.steps(BEVEL_STEPS);
    for (int i = 0; i <= steps; i++) {
      double out = Math.sin(Math.PI / 2 * i / steps);
      double down = Math.cos(Math.PI / 2 * i / steps);
      knots.add(
          new Knot(
              pipe.point(angleRad, r - BEVEL_M * (1 - out), BEVEL_M * (1 - down)),
              pipe.direction(angleRad, out, -down)));
    }
  }

  /** From the tube, at height {@code startM}, into the barrel. */
  private List<Knot> fillet(
      Barrel barrel, double angleRad, double entersM, double startM, double sizeM) {
    double r = pipe.radiusM(entersM);
    Fillet surface = new Fillet(pipe, barrel, sizeM);
    Vector3f onTube = pipe.point(angleRad, pipe.radiusM(startM), startM);
    Vector3f corner = pipe.point(angleRad, r, entersM);
    Vector3f onBarrel = pipe.point(angleRad, r + sizeM, entersM);
    onBarrel.fma((float) -barrel.distanceM(onBarrel), barrel.normal(onBarrel));
    List<Knot> knots = new ArrayList<>();
    int steps = detail.steps(FILLET_STEPS);
    for (int i = 0; i <= steps; i++) {
      float t = (float) i / steps;
      Vector3f point = new Vector3f(onTube).mul((1 - t) * (1 - t));
      point.fma(2 * t * (1 - t), corner).fma(t * t, onBarrel);
      surface.attract(point);
      Vector3f normal = surface.normal(point);
      if (i == steps) {
        point.fma(-SUNK_M, normal);
      }
      knots.add(new Knot(point, normal));
    }
    return knots;
  }

  /** The height at which a stave enters a barrel whose middle is at {@code middleM}. */
  private double enters(Barrel barrel, double angleRad, double middleM) {
    double outside = pipe.lengthM() - middleM;
    if (near.isPresent()) {
      outside = pipe.lengthM() / 2;
    }
    double inside = middleM;
    for (int i = 0; i < 40; i++) {
      double between = (outside + inside) / 2;
      double r = pipe.radiusM(between);
      if (barrel.distanceM(pipe.point(angleRad, r, between)) > 0) {
        outside = between;
      } else {
        inside = between;
      }
    }
    return inside;
  }

  private double sizeM(Barrel barrel, double angleRad, double entersM, double roomM) {
    double r = pipe.radiusM(entersM);
    double endways = Math.abs(pipe.direction(angleRad, 1, 0).dot(barrel.axis()));
    double toEndM = barrel.roomM(pipe.point(angleRad, r, entersM)) / Math.max(endways, 0.2);
    double maxPartWidthM = Math.min(filletM, Math.min(0.7 * roomM, 0.8 * toEndM));
    return Math.max(maxPartWidthM, MIN_FILLET_M);
  }
}
