package org.pendant.models.mesh;

import static org.pendant.models.mesh.MeshFileTexts.text;

import java.util.Arrays;
import org.pendant.models.json.Json;

/**
 * OBJ reader: reads points and faces; all else, such as normals and materials, is passed over.
 * Faces with more than three corners are cut into triangles around their first one.
 */
final class ObjReader {
  private final MeshAssembly into;
  private int[] points = new int[64];
  private int count;

  ObjReader(MeshAssembly into) {
    this.into = into;
  }

  void read(byte[] bytes) throws MeshException {
    MeshLines lines = new MeshLines(bytes);
    while (lines.next()) {
      if (lines.is("v")) {
        addPoint(lines);
      } else if (lines.is("f")) {
        addFace(lines);
      }
    }
  }

  private void addPoint(MeshLines lines) throws MeshException {
    if (count == points.length) {
      points = Arrays.copyOf(points, 2 * count);
    }
    points[count++] = into.point(lines::where, lines.number(1), lines.number(2), lines.number(3));
  }

  private void addFace(MeshLines lines) throws MeshException {
    if (lines.words() < 4) {
      throw new MeshException(text("faceCorners", lines.where()));
    }
    int first = point(lines, 1);
    int before = point(lines, 2);
    for (int i = 3; i < lines.words(); i++) {
      int next = point(lines, i);
      into.triangle(first, before, next);
      before = next;
    }
  }

  /** The point of a corner such as {@code 3}, {@code 3/1/2}, or {@code -1} for the latest one. */
  private int point(MeshLines lines, int word) throws MeshException {
    String corner = lines.word(word);
    int slash = corner.indexOf('/');
    String number = slash < 0 ? corner : corner.substring(0, slash);
    int index;
    try {
      index = Integer.parseInt(number);
    } catch (NumberFormatException _) {
      throw new MeshException(text("noPointNumber", lines.where(), Json.quoted(corner)));
    }
    int place = index < 0 ? count + index : index - 1;
    if (place < 0 || place >= count) {
      throw new MeshException(text("pointNotYet", lines.where(), index, count));
    }
    return points[place];
  }
}
