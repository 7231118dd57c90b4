package org.pendant.desktop.scene;

import org.joml.Matrix4f;
import org.joml.Vector3f;
import org.pendant.controller.device.Zone;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.mesh.Lines;
import org.pendant.models.pose.Pose;

/** Device outlines: where sensors see something, in a colour that says whether they do. */
public final class DeviceOutlines {
  private static final int ROUND = 48;
  private static final double FAINT = 0.5;

  /** Where the picture of a camera is drawn on the way to what it sees. */
  private static final float PICTURE_SHARE = 0.15f;

  private final Lines lines = new Lines();
  private final Matrix4f cellInBase;

  private DeviceOutlines(Pose cellInBase) {
    this.cellInBase = LinkPlaces.matrix(cellInBase);
  }

  /** The lines of all sensors. */
  public static Lines of(DeviceSight devices, SceneTheme theme) {
    DeviceOutlines made = new DeviceOutlines(devices.cellInBase());
    for (DeviceSight.Sensor each : devices.sensors()) {
      made.add(each.zone(), rgb(each.sees(), theme), each.sees() ? 1 : FAINT);
    }
    for (DeviceSight.CameraView each : devices.views()) {
      made.addView(each, rgb(true, theme));
    }
    return made.lines;
  }

  /** The colour of a sensor. */
  static int rgb(boolean sees, SceneTheme theme) {
    boolean light = theme == SceneTheme.LIGHT;
    if (sees) {
      return light ? 0xD9480F : 0xFF8A4C;
    }
    return light ? 0x1F8A78 : 0x4FC9B2;
  }

  /** Where the name of a sensor stands. */
  public static Vector3 namePlace(DeviceSight devices, Zone zone) {
    return devices.placed(namePlace(zone));
  }

  private static Vector3 namePlace(Zone zone) {
    return switch (zone) {
      case Zone.Beam beam -> vector(beam.from());
      case Zone.Ball ball ->
          new Vector3(ball.at().x(), ball.at().y(), ball.at().z() + ball.rangeM());
      case Zone.Area area -> vector(area.max());
    };
  }

  private static Vector3 vector(Zone.Place place) {
    return new Vector3(place.x(), place.y(), place.z());
  }

  private void add(Zone zone, int rgb, double faint) {
    switch (zone) {
      case Zone.Beam beam -> addBeam(beam, rgb, faint);
      case Zone.Ball ball -> {
        Vector3f at = point(ball.at());
        float radius = (float) ball.rangeM();
        Vector3f x = new Vector3f(radius, 0, 0);
        Vector3f y = new Vector3f(0, radius, 0);
        Vector3f z = new Vector3f(0, 0, radius);
        circle(at, x, y, rgb, faint);
        circle(at, y, z, rgb, faint);
        circle(at, z, x, rgb, faint);
      }
      case Zone.Area area -> addBox(area, rgb, faint);
    }
  }

  /** Its line at full strength, and how near is seen at both ends. */
  private void addBeam(Zone.Beam beam, int rgb, double faint) {
    Vector3f from = point(beam.from());
    Vector3f to = point(beam.to());
    line(from, to, rgb, 1);
    Vector3f along = new Vector3f(to).sub(from);
    if (along.length() > 0) {
      along.normalize();
      Vector3f other = Math.abs(along.z) < 0.9f ? new Vector3f(0, 0, 1) : new Vector3f(1, 0, 0);
      Vector3f u = new Vector3f(along).cross(other).normalize((float) beam.radiusM());
      Vector3f v = new Vector3f(along).cross(u).normalize((float) beam.radiusM());
      circle(from, u, v, rgb, faint);
      circle(to, u, v, rgb, faint);
      for (Vector3f side : new Vector3f[] {u, v}) {
        line(new Vector3f(from).add(side), new Vector3f(to).add(side), rgb, faint / 2);
        line(new Vector3f(from).sub(side), new Vector3f(to).sub(side), rgb, faint / 2);
      }
    }
  }

  /** A pyramid from the camera to the far side of what it sees, with its picture near the top. */
  private void addView(DeviceSight.CameraView view, int rgb) {
    Vector3 at = view.eyeInCell();
    Vector3f eye = new Vector3f((float) at.x(), (float) at.y(), (float) at.z());
    Vector3f[] far = farSide(eye, point(view.area().min()), point(view.area().max()));
    for (int i = 0; i < far.length; i++) {
      Vector3f next = far[(i + 1) % far.length];
      line(eye, far[i], rgb, 1);
      line(far[i], next, rgb, 1);
      line(
          new Vector3f(eye).lerp(far[i], PICTURE_SHARE),
          new Vector3f(eye).lerp(next, PICTURE_SHARE),
          rgb,
          1);
    }
  }

  /** The corners of the side of a box that is farthest from a point, in a row around it. */
  private static Vector3f[] farSide(Vector3f from, Vector3f min, Vector3f max) {
    int axis = 0;
    float farthest = -1;
    boolean atMax = false;
    for (int i = 0; i < 3; i++) {
      float toMin = Math.abs(from.get(i) - min.get(i));
      float toMax = Math.abs(from.get(i) - max.get(i));
      if (Math.max(toMin, toMax) > farthest) {
        farthest = Math.max(toMin, toMax);
        axis = i;
        atMax = toMax > toMin;
      }
    }
    int u = (axis + 1) % 3;
    int v = (axis + 2) % 3;
    Vector3f[] corners = new Vector3f[4];
    for (int i = 0; i < corners.length; i++) {
      Vector3f corner = new Vector3f(min);
      corner.setComponent(axis, (atMax ? max : min).get(axis));
      corner.setComponent(u, (i == 1 || i == 2 ? max : min).get(u));
      corner.setComponent(v, (i >= 2 ? max : min).get(v));
      corners[i] = corner;
    }
    return corners;
  }

  private void addBox(Zone.Area area, int rgb, double opacity) {
    Zone.Place min = area.min();
    Zone.Place max = area.max();
    for (int axis = 0; axis < 3; axis++) {
      for (int i = 0; i < 4; i++) {
        Vector3f from = point(min);
        int u = (axis + 1) % 3;
        int v = (axis + 2) % 3;
        Vector3f far = point(max);
        if ((i & 1) != 0) {
          from.setComponent(u, far.get(u));
        }
        if ((i & 2) != 0) {
          from.setComponent(v, far.get(v));
        }
        Vector3f to = new Vector3f(from).setComponent(axis, far.get(axis));
        line(from, to, rgb, opacity);
      }
    }
  }

  private void circle(Vector3f middle, Vector3f u, Vector3f v, int rgb, double opacity) {
    for (int i = 0; i <= ROUND; i++) {
      double a = 2 * Math.PI * i / ROUND;
      Vector3f p =
          cellInBase.transformPosition(
              new Vector3f(middle).fma((float) Math.cos(a), u).fma((float) Math.sin(a), v));
      if (i == 0) {
        lines.from(p.x, p.y, p.z, rgb, opacity);
      } else {
        lines.to(p.x, p.y, p.z, rgb, opacity);
      }
    }
  }

  private void line(Vector3f from, Vector3f to, int rgb, double opacity) {
    Vector3f a = cellInBase.transformPosition(from, new Vector3f());
    Vector3f b = cellInBase.transformPosition(to, new Vector3f());
    lines.from(a.x, a.y, a.z, rgb, opacity).to(b.x, b.y, b.z, rgb, opacity);
  }

  private static Vector3f point(Zone.Place place) {
    return new Vector3f((float) place.x(), (float) place.y(), (float) place.z());
  }
}
