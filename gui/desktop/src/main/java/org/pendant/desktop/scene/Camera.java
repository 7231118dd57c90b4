package org.pendant.desktop.scene;

import java.awt.geom.Point2D;
import java.util.Optional;
import org.joml.Matrix4f;
import org.joml.Vector3d;
import org.pendant.command.service.StandardView;
import org.pendant.controller.world.Vector3;

/**
 * Camera: where the scene is seen from: an eye that looks at a point and keeps z upright. Every
 * change gives a new camera.
 *
 * @param targetM the point in the middle of the picture, in the base frame, m
 * @param azimuthRad direction from the target to the eye, from x towards y, rad
 * @param elevationRad how far above the horizontal the eye is, -pi/2 to pi/2, rad
 * @param distanceM from the eye to the target, {@value #NEAREST_M} to {@value #MAX_M} m
 * @param lens how depth is shown; what is at the target has the same size in both
 */
public record Camera(
    Vector3 targetM, double azimuthRad, double elevationRad, double distanceM, Lens lens) {
  /** Least distance from the target, m. */
  public static final double NEAREST_M = 0.05;

  /** Largest distance from the target, m. */
  public static final double MAX_M = 40;

  /** Half the angle that the height of a picture spans, rad. */
  private static final double HALF_HEIGHT_RAD = Math.toRadians(16);

  private static final double TANGENT = Math.tan(HALF_HEIGHT_RAD);

  /** Nearest thing drawn, as a share of the distance. */
  private static final double NEAR_SHARE = 0.03;

  private static final double BEHIND_TARGET_M = 60;

  /** Without perspective this much is seen before and behind the target, m. */
  private static final double DEPTH_M = 30;

  private static final int FITTING_TURNS = 12;
  private static final double FITTING_MARGIN = 1.12;

  /** Keeps elevation and distance in their ranges. */
  public Camera {
    elevationRad = Math.clamp(elevationRad, -Math.PI / 2, Math.PI / 2);
    distanceM = Math.clamp(distanceM, NEAREST_M, MAX_M);
  }

  /** With perspective. */
  public Camera(Vector3 targetM, double azimuthRad, double elevationRad, double distanceM) {
    this(targetM, azimuthRad, elevationRad, distanceM, Lens.PERSPECTIVE);
  }

  /**
   * A camera that shows all of something from a standard direction.
   *
   * @param aspect width of the picture divided by its height
   */
  public static Camera of(StandardView view, SceneBounds outline, double aspect) {
    Vector3 start = outline.balls().getFirst().centreM();
    return new Camera(start, view.azimuthRad(), view.elevationRad(), MAX_M).fitted(outline, aspect);
  }

  /** From the same direction, placed so that something fills the picture. */
  public Camera fitted(SceneBounds outline, double aspect) {
    return fitted(outline, aspect, 0, 0);
  }

  /**
   * As {@link #fitted(SceneBounds, double)}, clear of what covers the picture at its edges.
   *
   * @param topShare how much of its height is covered at the top, 0 to below 1
   * @param bottomShare how much at the bottom; less than 1 with that at the top
   */
  public Camera fitted(SceneBounds outline, double aspect, double topShare, double bottomShare) {
    Camera camera = this;
    // Each turn corrects what the change of perspective by the one before has left.
    for (int i = 0; i < FITTING_TURNS; i++) {
      camera = camera.fittedOnce(outline, aspect, topShare, bottomShare);
    }
    return camera;
  }

  private Camera fittedOnce(
      SceneBounds outline, double aspect, double topShare, double bottomShare) {
    double left = Double.POSITIVE_INFINITY;
    double right = Double.NEGATIVE_INFINITY;
    double bottom = Double.POSITIVE_INFINITY;
    double top = Double.NEGATIVE_INFINITY;
    for (Ball ball : outline.balls()) {
      Vector3d from = vector(ball.centreM()).sub(vector(eyeM()));
      double depthM = depthM(from);
      double pad = ball.radiusM() / depthM;
      double x = from.dot(right()) / depthM;
      double y = from.dot(up()) / depthM;
      left = Math.min(left, x - pad);
      right = Math.max(right, x + pad);
      bottom = Math.min(bottom, y - pad);
      top = Math.max(top, y + pad);
    }
    double high = (top - bottom) / (1 - topShare - bottomShare);
    double factor = FITTING_MARGIN * Math.max((right - left) / aspect, high) / (2 * TANGENT);
    // the middle of what is not covered is so far above that of the picture
    double above = factor * TANGENT * (bottomShare - topShare);
    Vector3d target = vector(targetM);
    target.fma(distanceM * (left + right) / 2, right());
    target.fma(distanceM * ((bottom + top) / 2 - above), up());
    return new Camera(vector(target), azimuthRad, elevationRad, factor * distanceM, lens);
  }

  /** The distance that says how large something is seen. */
  private double depthM(Vector3d fromEye) {
    return switch (lens) {
      case PERSPECTIVE -> Math.max(fromEye.dot(forward()), NEAREST_M);
      case ORTHOGRAPHIC -> distanceM;
    };
  }

  /** The same place seen from a standard direction. */
  public Camera from(StandardView view) {
    return new Camera(targetM, view.azimuthRad(), view.elevationRad(), distanceM, lens);
  }

  /** The same place seen through another lens. */
  public Camera through(Lens other) {
    return new Camera(targetM, azimuthRad, elevationRad, distanceM, other);
  }

  /** Turned about the target, by angles in rad. */
  public Camera orbited(double azimuthByRad, double elevationByRad) {
    return new Camera(
        targetM,
        Math.IEEEremainder(azimuthRad + azimuthByRad, 2 * Math.PI),
        elevationRad + elevationByRad,
        distanceM,
        lens);
  }

  /**
   * Moved so that what is at the target follows the pointer.
   *
   * @param rightPx how far the pointer went to the right
   * @param downPx how far it went down
   * @param heightPx height of the picture
   */
  public Camera panned(double rightPx, double downPx, double heightPx) {
    double pixelM = 2 * distanceM * TANGENT / heightPx;
    Vector3d target = vector(targetM);
    target.fma(-rightPx * pixelM, right()).fma(downPx * pixelM, up());
    return new Camera(vector(target), azimuthRad, elevationRad, distanceM, lens);
  }

  /** At {@code factor} times the distance. */
  public Camera dollied(double factor) {
    return new Camera(targetM, azimuthRad, elevationRad, factor * distanceM, lens);
  }

  /**
   * At {@code factor} times the distance, and the point of the target's plane that is seen at a
   * pixel stays there.
   */
  public Camera dolliedAt(double factor, double xPx, double yPx, double widthPx, double heightPx) {
    Camera nearer = dollied(factor);
    double share = 1 - nearer.distanceM / distanceM;
    double halfM = share * distanceM * TANGENT;
    Vector3d target = vector(targetM);
    target.fma(halfM * across(xPx, widthPx, heightPx), right());
    target.fma(halfM * above(yPx, heightPx), up());
    return new Camera(vector(target), azimuthRad, elevationRad, nearer.distanceM, lens);
  }

  /** Looking at a point, m, from a distance, m. */
  public Camera zoomedTo(Vector3 pointM, double fromM) {
    return new Camera(pointM, azimuthRad, elevationRad, fromM, lens);
  }

  /** Where the eye is, m. */
  public Vector3 eyeM() {
    return vector(vector(targetM).fma(-distanceM, forward()));
  }

  /** Whether a level plane at a height, m, shows its upper side. */
  public boolean looksDownOn(double heightM) {
    return switch (lens) {
      case PERSPECTIVE -> eyeM().z() > heightM;
      case ORTHOGRAPHIC -> elevationRad > 0;
    };
  }

  /** What is seen at a pixel, from the eye onwards; pixels count from the top left corner. */
  public Ray ray(double xPx, double yPx, double widthPx, double heightPx) {
    double right = TANGENT * across(xPx, widthPx, heightPx);
    double up = TANGENT * above(yPx, heightPx);
    return switch (lens) {
      case PERSPECTIVE -> {
        Vector3d direction = forward().fma(right, right()).fma(up, up());
        yield new Ray(eyeM(), vector(direction.normalize()));
      }
      case ORTHOGRAPHIC -> {
        Vector3d from = vector(eyeM()).fma(distanceM * right, right()).fma(distanceM * up, up());
        yield new Ray(vector(from), vector(forward()));
      }
    };
  }

  /**
   * Where a point of the base frame, m, is seen, in pixels from the top left corner; empty for one
   * behind the eye.
   */
  public Optional<Point2D> pixel(Vector3 pointM, double widthPx, double heightPx) {
    Vector3d from = vector(pointM).sub(vector(eyeM()));
    double depthM = lens == Lens.PERSPECTIVE ? from.dot(forward()) : distanceM;
    if (depthM <= 0) {
      return Optional.empty();
    }
    double unitPx = heightPx / (2 * TANGENT * depthM);
    return Optional.of(
        new Point2D.Double(
            widthPx / 2 + unitPx * from.dot(right()), heightPx / 2 - unitPx * from.dot(up())));
  }

  /** From the base frame to clip space, with the top of the picture at y = 1. */
  public Matrix4f projection(double aspect) {
    Vector3d eye = vector(eyeM());
    Vector3d target = vector(targetM);
    Vector3d up = up();
    return lens(aspect)
        .lookAt(
            (float) eye.x,
            (float) eye.y,
            (float) eye.z,
            (float) target.x,
            (float) target.y,
            (float) target.z,
            (float) up.x,
            (float) up.y,
            (float) up.z);
  }

  private Matrix4f lens(double aspect) {
    return switch (lens) {
      case PERSPECTIVE ->
          new Matrix4f()
              .perspective(
                  (float) (2 * HALF_HEIGHT_RAD),
                  (float) aspect,
                  (float) (NEAR_SHARE * distanceM),
                  (float) (distanceM + BEHIND_TARGET_M));
      case ORTHOGRAPHIC -> {
        float half = (float) (distanceM * TANGENT);
        yield new Matrix4f()
            .orthoSymmetric(
                2 * half * (float) aspect,
                2 * half,
                (float) (distanceM - DEPTH_M),
                (float) (distanceM + DEPTH_M));
      }
    };
  }

  /** Units of half the picture's height, to the right of its middle. */
  private static double across(double xPx, double widthPx, double heightPx) {
    return (2 * xPx - widthPx) / heightPx;
  }

  /** Units of half the picture's height, above its middle. */
  private static double above(double yPx, double heightPx) {
    return 1 - 2 * yPx / heightPx;
  }

  private Vector3d forward() {
    double flat = Math.cos(elevationRad);
    return new Vector3d(
        -flat * Math.cos(azimuthRad), -flat * Math.sin(azimuthRad), -Math.sin(elevationRad));
  }

  private Vector3d right() {
    return new Vector3d(-Math.sin(azimuthRad), Math.cos(azimuthRad), 0);
  }

  /** Written out, so that it is also defined when looking straight down. */
  private Vector3d up() {
    double leaning = -Math.sin(elevationRad);
    return new Vector3d(
        leaning * Math.cos(azimuthRad), leaning * Math.sin(azimuthRad), Math.cos(elevationRad));
  }

  private static Vector3d vector(Vector3 v) {
    return new Vector3d(v.x(), v.y(), v.z());
  }

  private static Vector3 vector(Vector3d v) {
    return new Vector3(v.x, v.y, v.z);
  }
}
