package org.pendant.desktop.whatif;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;
import java.util.function.IntUnaryOperator;
import org.pendant.desktop.scene.ComparedWays;
import org.pendant.recording.whatif.TcpWay;

/**
 * Variant sights: what of variants is to be seen in 3D, each in the colour of its row.
 *
 * @param selected row of the table; below 0 for none
 * @param rgb the colour of a row, 0xRRGGBB
 */
record VariantSights(
    List<VariantRow> rows, List<VariantResult> results, int selected, IntUnaryOperator rgb) {
  /** Copies the lists. */
  VariantSights {
    rows = List.copyOf(rows);
    results = List.copyOf(results);
  }

  /** Where the tool went in each. */
  List<ComparedWays.Way> ways() {
    List<ComparedWays.Way> found = new ArrayList<>();
    for (int i = 0; i < results.size(); i++) {
      TcpWay way = results.get(i).finished().map(each -> each.way()).orElse(TcpWay.NONE);
      if (way.size() > 1) {
        found.add(new ComparedWays.Way(rows.get(i).name(), rgb.applyAsInt(i), i == selected, way));
      }
    }
    return found;
  }

  /**
   * Where the arm is in each at the same robot time.
   *
   * @param frame of the run that they are variants of; empty for none to be seen
   */
  List<ComparedWays.Ghost> ghosts(OptionalLong frame) {
    List<ComparedWays.Ghost> found = new ArrayList<>();
    for (int i = 0; frame.isPresent() && i < results.size(); i++) {
      int row = i;
      results
          .get(i)
          .finished()
          .flatMap(each -> each.track().at(frame.getAsLong()))
          .ifPresent(
              positionRad ->
                  found.add(
                      new ComparedWays.Ghost(
                          rows.get(row).name(),
                          rgb.applyAsInt(row),
                          row == selected,
                          positionRad)));
    }
    return found;
  }
}
