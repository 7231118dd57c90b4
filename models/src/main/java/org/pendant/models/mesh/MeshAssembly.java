package org.pendant.models.mesh;

import static org.pendant.models.mesh.MeshFileTexts.text;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import org.pendant.models.json.JsonValues;

/**
 * Mesh assembly: makes a solid of the triangles of a file, and refuses what is none. Points at the
 * same place are one, and where the surface is open otherwise, those that nearly are.
 */
final class MeshAssembly {
  /** Coordinates beyond this are no lengths of anything, m. */
  private static final double MAX_COORDINATE_M = 100;

  /** How near points are that are joined where the surface is open, of its longest side. */
  private static final List<Double> JOINED = List.of(1e-6, 1e-5, 1e-4);

  private final double scale;
  private final Map<Place, Integer> numbers = new HashMap<>();
  private double[] points = new double[3 * 64];
  private int[] corners = new int[3 * 128];

  /** The colour of each triangle; {@link TriangleMesh#NO_COLOUR} for none. */
  private int[] colours = new int[128];

  private int colour = TriangleMesh.NO_COLOUR;
  private int cornerCount;
  private int read;

  private record Place(double x, double y, double z) {}

  MeshAssembly(MeshUnit unit) {
    scale = unit.lengthM();
  }

  /**
   * The number of a point.
   *
   * @param where it is in the file, for messages
   */
  int point(Supplier<String> where, double x, double y, double z) throws MeshException {
    for (double each : new double[] {x, y, z}) {
      if (!Double.isFinite(each)) {
        throw new MeshException(text("coordinateNoNumber", where.get(), each));
      }
      if (Math.abs(each * scale) > MAX_COORDINATE_M) {
        throw new MeshException(
            text(
                "coordinateTooLarge",
                where.get(),
                each,
                String.format(Locale.ROOT, "%.3g", each * scale),
                String.format(Locale.ROOT, "%.0f", MAX_COORDINATE_M)));
      }
    }
    // adding 0 makes one zero of both
    Place place = new Place(x * scale + 0.0, y * scale + 0.0, z * scale + 0.0);
    Integer known = numbers.get(place);
    if (known != null) {
      return known;
    }
    int number = numbers.size();
    if (number == 3 * TriangleMesh.MAX_TRIANGLES) {
      throw new MeshException(text("tooManyPoints", where.get(), number));
    }
    if (3 * number == points.length) {
      points = Arrays.copyOf(points, 2 * points.length);
    }
    points[3 * number] = place.x();
    points[3 * number + 1] = place.y();
    points[3 * number + 2] = place.z();
    numbers.put(place, number);
    return number;
  }

  /**
   * The colour of the triangles that follow.
   *
   * @param rgb as screens have it; {@link TriangleMesh#NO_COLOUR} for none
   */
  void colour(int rgb) {
    colour = rgb;
  }

  /** Adds a triangle; one with two corners at the same place is nothing, and left out. */
  void triangle(int a, int b, int c) throws MeshException {
    if (++read > TriangleMesh.MAX_TRIANGLES) {
      throw new MeshException(tooMany(text("moreThan", TriangleMesh.MAX_TRIANGLES)));
    }
    if (a == b || b == c || c == a) {
      return;
    }
    if (cornerCount == corners.length) {
      corners = Arrays.copyOf(corners, 2 * corners.length);
      colours = Arrays.copyOf(colours, 2 * colours.length);
    }
    colours[cornerCount / 3] = colour;
    corners[cornerCount++] = a;
    corners[cornerCount++] = b;
    corners[cornerCount++] = c;
  }

  static String tooMany(String count) {
    return text("tooManyTriangles", count, TriangleMesh.MAX_TRIANGLES);
  }

  /** What can be told of it, whether it is a solid or not. */
  MeshLook look() {
    Optional<TriangleMesh> mesh = Optional.empty();
    Optional<String> problem = Optional.empty();
    try {
      mesh = Optional.of(mesh());
    } catch (MeshException e) {
      problem = Optional.of(e.getMessage());
    }
    return new MeshLook(corners.length / 3, length(0), length(1), length(2), mesh, problem);
  }

  /** The solid. */
  TriangleMesh mesh() throws MeshException {
    if (read == 0) {
      corners = new int[0];
      points = new double[0];
      throw new MeshException(text("noTriangles"));
    }
    corners = Arrays.copyOf(corners, cornerCount);
    if (cornerCount == 0) {
      throw new MeshException(text("noArea"));
    }
    keepUsed();
    requireSize();
    requireClosed();
    double volume = TriangleMesh.volume(points, corners);
    if (volume < 0) {
      turn();
    }
    TriangleMesh mesh =
        new TriangleMesh(points, corners, Arrays.copyOf(colours, corners.length / 3));
    double longest = longest();
    if (mesh.volumeM3() < 1e-9 * longest * longest * longest) {
      throw new MeshException(text("fillsNoSpace"));
    }
    return mesh;
  }

  /** Keeps the points that triangles have, in the order in which they have them. */
  private void keepUsed() {
    int[] kept = new int[points.length / 3];
    double[] used = new double[3 * Math.min(kept.length, corners.length)];
    int count = 0;
    for (int i = 0; i < corners.length; i++) {
      int point = corners[i];
      if (kept[point] == 0) {
        System.arraycopy(points, 3 * point, used, 3 * count, 3);
        kept[point] = ++count;
      }
      corners[i] = kept[point] - 1;
    }
    points = Arrays.copyOf(used, 3 * count);
  }

  private double longest() {
    return Math.max(length(0), Math.max(length(1), length(2)));
  }

  private double length(int axis) {
    double least = Double.POSITIVE_INFINITY;
    double most = Double.NEGATIVE_INFINITY;
    for (int i = axis; i < points.length; i += 3) {
      least = Math.min(least, points[i]);
      most = Math.max(most, points[i]);
    }
    return Math.max(0, most - least);
  }

  private void requireSize() throws MeshException {
    double longest = longest();
    if (longest > TriangleMesh.MAX_LENGTH_M || longest < TriangleMesh.MIN_LENGTH_M) {
      throw new MeshException(text("wrongLength", String.format(Locale.ROOT, "%.3g", longest)));
    }
  }

  /**
   * Refuses what is not closed. If it is only where points are that are meant to be one, these are
   * joined: the nearest first, so that no more than needed are.
   */
  private void requireClosed() throws MeshException {
    OpenEdges open = new OpenEdges(corners);
    for (int i = 0; i < JOINED.size() && open.count() > 0; i++) {
      join(JOINED.get(i) * longest());
      open = new OpenEdges(corners);
    }
    if (corners.length == 0) {
      throw new MeshException(text("noArea"));
    }
    long count = open.count();
    if (count > 0) {
      int[] first = open.first();
      throw new MeshException(
          count == 1
              ? text("oneOpenEdge", place(first[0]), place(first[1]))
              : text("openEdges", count, place(first[0]), place(first[1])));
    }
  }

  /** Makes one of points that are as near as that; triangles that are nothing then go. */
  private void join(double withinM) {
    int[] first = PointJoin.firstWithin(points, withinM);
    int kept = 0;
    for (int i = 0; i < corners.length; i += 3) {
      int a = first[corners[i]];
      int b = first[corners[i + 1]];
      int c = first[corners[i + 2]];
      if (a != b && b != c && c != a) {
        colours[kept / 3] = colours[i / 3];
        corners[kept++] = a;
        corners[kept++] = b;
        corners[kept++] = c;
      }
    }
    corners = Arrays.copyOf(corners, kept);
    keepUsed();
  }

  /** Where a point is, as the file has it. */
  private String place(int point) {
    return "("
        + inFile(3 * point)
        + ", "
        + inFile(3 * point + 1)
        + ", "
        + inFile(3 * point + 2)
        + ")";
  }

  private String inFile(int index) {
    return JsonValues.number(Math.rint(points[index] / scale * 1e4) / 1e4);
  }

  /** Has all triangles face the other way. */
  private void turn() {
    for (int i = 0; i < corners.length; i += 3) {
      int second = corners[i + 1];
      corners[i + 1] = corners[i + 2];
      corners[i + 2] = second;
    }
  }
}
