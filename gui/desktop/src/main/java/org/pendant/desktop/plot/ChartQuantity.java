package org.pendant.desktop.plot;

import java.util.function.Supplier;
import java.util.function.ToDoubleFunction;
import org.pendant.controller.state.ControllerState;
import org.pendant.desktop.workbench.ScreenUnit;

/**
 * Chart quantity: a number that changes over time and can be drawn. Two of the same id are equal.
 *
 * @param id stable name in settings and files, such as {@code actual_q_0}
 * @param group where it stands in the list, levels separated by {@code /}
 * @param title what people read below the group
 * @param label what people read where the group is not to be seen, as in legends
 * @param unit what its values are in, empty for none
 * @param value reads it from a snapshot; not a number where the snapshot does not have it
 * @param given the name that people have given to it, asked for anew each time; empty for none
 * @param hint what it is in more words, which a search finds as well; may be empty
 */
public record ChartQuantity(
    String id,
    String group,
    String title,
    String label,
    String unit,
    ToDoubleFunction<ControllerState> value,
    Supplier<String> given,
    String hint) {
  /** One that people do not name. */
  public ChartQuantity(
      String id,
      String group,
      String title,
      String label,
      String unit,
      ToDoubleFunction<ControllerState> value) {
    this(id, group, title, label, unit, value, () -> "", "");
  }

  /** Whether it only has the values 0 and 1. */
  public boolean digital() {
    return unit.equals(ScreenUnit.LEVEL);
  }

  /** Whether it is a script variable, of which every frame is kept. */
  boolean variable() {
    return id.startsWith(ScriptVariables.PREFIX);
  }

  /** The title, behind the name that people have given. */
  String namedTitle() {
    return named(title);
  }

  /** The label, behind the name that people have given. */
  String namedLabel() {
    return named(label);
  }

  private String named(String text) {
    String name = given.get();
    return name.isEmpty() ? text : name + " (" + text + ")";
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof ChartQuantity quantity && id.equals(quantity.id);
  }

  @Override
  public int hashCode() {
    return id.hashCode();
  }
}
