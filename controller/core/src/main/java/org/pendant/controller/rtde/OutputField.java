package org.pendant.controller.rtde;

import org.pendant.controller.quantity.StateQuantity;

/**
 * Output field: something about the controller that RTDE clients may ask for by its name, and
 * programs with {@code get_rtde_value} (manual 18.10).
 *
 * @param name such as {@code actual_q}
 * @param quantity what it tells
 * @param from the first of its components that the field has
 * @param count how many it has
 */
public record OutputField(String name, StateQuantity quantity, int from, int count) {

  /** The type of its values. */
  public FieldType type() {
    return FieldType.of(quantity.type(), count);
  }
}
