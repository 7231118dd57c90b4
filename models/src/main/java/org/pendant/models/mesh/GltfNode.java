package org.pendant.models.mesh;

import static org.pendant.models.mesh.MeshFileTexts.text;

import org.pendant.models.json.JsonException;
import org.pendant.models.json.JsonFields;

/** glTF node: where what is in a node of a file is, as a matrix of columns. */
final class GltfNode {
  private static final int NUMBERS = 16;

  private GltfNode() {}

  /** The matrix of a node: its own one, or made of shift, turn and scale. */
  static double[] matrix(JsonFields node) throws JsonException {
    if (node.optional("matrix").isPresent()) {
      double[] matrix = node.vector("matrix", NUMBERS);
      if (matrix[3] != 0 || matrix[7] != 0 || matrix[11] != 0 || matrix[15] != 1) {
        throw node.required("matrix").place().refusal(text("matrixRow"));
      }
      return matrix;
    }
    double[] shift = vector(node, "translation", 0, 0, 0);
    double[] turn = vector(node, "rotation", 0, 0, 0, 1);
    double[] scale = vector(node, "scale", 1, 1, 1);
    double x = turn[0];
    double y = turn[1];
    double z = turn[2];
    double w = turn[3];
    double length = x * x + y * y + z * z + w * w;
    if (!(Math.abs(length - 1) < 0.01)) {
      throw node.required("rotation").place().refusal(text("rotation"));
    }
    double s = 2 / length;
    return new double[] {
      scale[0] * (1 - s * (y * y + z * z)),
      scale[0] * s * (x * y + z * w),
      scale[0] * s * (x * z - y * w),
      0,
      scale[1] * s * (x * y - z * w),
      scale[1] * (1 - s * (x * x + z * z)),
      scale[1] * s * (y * z + x * w),
      0,
      scale[2] * s * (x * z + y * w),
      scale[2] * s * (y * z - x * w),
      scale[2] * (1 - s * (x * x + y * y)),
      0,
      shift[0],
      shift[1],
      shift[2],
      1
    };
  }

  private static double[] vector(JsonFields node, String key, double... otherwise)
      throws JsonException {
    return node.optional(key).isPresent() ? node.vector(key, otherwise.length) : otherwise;
  }

  /** Whether a matrix turns what is left into what is right, so that faces face inwards. */
  static boolean mirrors(double[] m) {
    return m[0] * (m[5] * m[10] - m[9] * m[6])
            - m[4] * (m[1] * m[10] - m[9] * m[2])
            + m[8] * (m[1] * m[6] - m[5] * m[2])
        < 0;
  }
}
