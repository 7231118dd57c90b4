package org.pendant.desktop.scene.gl;

import org.pendant.desktop.scene.mesh.Detail;

/** Quality: how much a picture may cost, the best first. A GPU always has time for the best. */
public enum Quality {
  /** Everything: for what stands still, and for files. */
  FULL(Detail.FINE, 4, Shadows.SOFT, 1),
  /** Fewer triangles, simpler shadows. */
  SMOOTH(Detail.COARSE, 4, Shadows.HARD, 1),
  /** Nor are edges smoothed: under half the time of {@link #FULL} without a GPU. */
  SWIFT(Detail.COARSE, 1, Shadows.HARD, 1),
  /** Every other pixel is drawn, those between are mixed. */
  HALF(Detail.COARSE, 1, Shadows.HARD, 2);

  private final Detail detail;
  private final int samples;
  private final Shadows shadows;
  private final int divisor;

  Quality(Detail detail, int samples, Shadows shadows, int divisor) {
    this.detail = detail;
    this.samples = samples;
    this.shadows = shadows;
    this.divisor = divisor;
  }

  /** How finely bodies are cut. */
  Detail detail() {
    return detail;
  }

  /** Samples of each pixel, 1 for edges that are not smoothed. */
  int samples() {
    return samples;
  }

  /** How many pixels of a row share one that is drawn. */
  int divisor() {
    return divisor;
  }

  /** How shadows end. */
  Shadows shadows() {
    return shadows;
  }
}
