package org.pendant.desktop.whatif;

import java.util.List;

/**
 * Variant columns: how wide columns are. Each has room for its content, as far as there is some;
 * where there is little, those that may be cut are narrower, the later ones first.
 */
final class VariantColumns {
  private VariantColumns() {}

  /**
   * A column.
   *
   * @param least width in pixels
   * @param wanted width by which all its content is whole, in pixels, at least {@code least}
   */
  record Width(int least, int wanted) {}

  /** What all columns need together at least, in pixels. */
  static int least(List<Width> columns) {
    return columns.stream().mapToInt(Width::least).sum();
  }

  /** By what all columns are whole together, in pixels. */
  static int whole(List<Width> columns) {
    return columns.stream().mapToInt(Width::wanted).sum();
  }

  /** The widths; the last column takes what is left over. */
  static int[] fit(int room, List<Width> columns) {
    int[] widths = columns.stream().mapToInt(Width::least).toArray();
    int left = Math.max(0, room - least(columns));
    for (int i = 0; i < widths.length; i++) {
      int more = Math.min(left, columns.get(i).wanted() - widths[i]);
      widths[i] += more;
      left -= more;
    }
    widths[widths.length - 1] += left;
    return widths;
  }
}
