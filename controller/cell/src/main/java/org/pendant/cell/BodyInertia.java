package org.pendant.cell;

/** Body inertia: of a shape whose mass is evenly spread, about its origin. */
public final class BodyInertia {
  private BodyInertia() {}

  /** Moments along the shape's own axes, kg m^2. */
  public static double[] of(BodyShape shape, double massKg) {
    return switch (shape) {
      case BodyShape.Box(double x, double y, double z) ->
          new double[] {
            massKg * (y * y + z * z) / 12,
            massKg * (z * z + x * x) / 12,
            massKg * (x * x + y * y) / 12
          };
      case BodyShape.Sphere(double r) -> round(0.4 * massKg * r * r, 0.4 * massKg * r * r);
      case BodyShape.Cylinder(double r, double length) ->
          round(massKg * (3 * r * r + length * length) / 12, massKg * r * r / 2);
      case BodyShape.Capsule(double r, double length) -> capsule(massKg, r, length);
      case BodyShape.Hull(_, double x, double y, double z) ->
          new double[] {massKg * x, massKg * y, massKg * z};
      case BodyShape.Compound(_, double x, double y, double z) ->
          new double[] {massKg * x, massKg * y, massKg * z};
      case BodyShape.HalfSpace(), BodyShape.Faces(_) -> round(1, 1);
    };
  }

  private static double[] capsule(double massKg, double r, double length) {
    double bar = massKg * length / (length + 4 * r / 3);
    double ends = massKg - bar;
    return round(
        bar * (3 * r * r + length * length) / 12
            + ends * (0.4 * r * r + length * length / 4 + 3 * length * r / 8),
        bar * r * r / 2 + ends * 0.4 * r * r);
  }

  private static double[] round(double across, double along) {
    return new double[] {across, across, along};
  }
}
