package org.pendant.desktop.cell;

import java.util.List;
import java.util.function.BiFunction;
import java.util.function.Function;
import org.pendant.controller.world.Vector3;
import org.pendant.kit.form.Measure;
import org.pendant.kit.form.PartsForm;

/** Axes: three rows of a form for the components of a vector. */
final class Axes {
  private static final List<String> NAMES = List.of("X", "Y", "Z");

  private Axes() {}

  /**
   * Adds them.
   *
   * @param label with which their labels begin; empty for the axes alone
   */
  static <T> void addTo(
      PartsForm<T> form,
      String name,
      String label,
      Measure unit,
      Function<T, Vector3> get,
      BiFunction<T, Vector3, T> with) {
    for (int i = 0; i < NAMES.size(); i++) {
      int axis = i;
      form.numberRow(
          (name + " " + NAMES.get(i)).strip(),
          (label + " " + NAMES.get(i)).strip(),
          unit,
          now -> component(get.apply(now), axis),
          (before, value) -> with.apply(before, with(get.apply(before), axis, value)));
    }
  }

  private static double component(Vector3 vector, int axis) {
    return switch (axis) {
      case 0 -> vector.x();
      case 1 -> vector.y();
      default -> vector.z();
    };
  }

  private static Vector3 with(Vector3 vector, int axis, double value) {
    return new Vector3(
        axis == 0 ? value : vector.x(),
        axis == 1 ? value : vector.y(),
        axis == 2 ? value : vector.z());
  }
}
