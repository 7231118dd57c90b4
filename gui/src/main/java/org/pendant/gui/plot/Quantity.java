package org.pendant.gui.plot;

import java.util.function.ToDoubleFunction;
import org.pendant.controller.state.ControllerState;

/**
 * A number that changes over time and can be drawn.
 *
 * @param id stable name in settings and files, such as {@code actual_q_0}
 * @param group where it stands in the list, levels separated by {@code /}
 * @param title what people read below the group
 * @param label what people read where the group is not to be seen, as in legends
 * @param unit what its values are in, empty for none
 * @param value reads it from a snapshot; not a number where the snapshot does not have it
 */
public record Quantity(
    String id,
    String group,
    String title,
    String label,
    String unit,
    ToDoubleFunction<ControllerState> value) {

  /** Whether it only has the values 0 and 1. */
  public boolean digital() {
    return unit.equals(DIGITAL);
  }

  /** The unit of levels. */
  static final String DIGITAL = "0/1";
}
