package org.pendant.models.mesh;

import java.util.Arrays;
import java.util.Optional;

/** Mesh unit: what the numbers of a file of triangles count; such files do not say it. */
public enum MeshUnit {
  /** Millimetres, as CAD programs mostly write. */
  MILLIMETRE("mm", 1e-3),
  /** Centimetres. */
  CENTIMETRE("cm", 1e-2),
  /** Metres. */
  METRE("m", 1),
  /** Inches. */
  INCH("in", 0.0254);

  private final String word;
  private final double lengthM;

  MeshUnit(String word, double lengthM) {
    this.word = word;
    this.lengthM = lengthM;
  }

  /** The unit that a word means. */
  public static Optional<MeshUnit> of(String word) {
    return Arrays.stream(values()).filter(each -> each.word.equals(word)).findFirst();
  }

  /** How it is written in files. */
  public String word() {
    return word;
  }

  /** How long it is, m. */
  public double lengthM() {
    return lengthM;
  }
}
