package org.pendant.controller.rtde;

import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.quantity.StateQuantities;
import org.pendant.controller.quantity.StateQuantity;

/**
 * Output fields: every one that RTDE clients may read: those state quantities that the interface
 * has a name for. Units are those of the SI, currents in A, temperatures in degrees Celsius,
 * execution times in microseconds; poses and what belongs to the TCP are in the base frame.
 */
public final class OutputFields {
  private static final Map<String, OutputField> FIELDS = fields();

  private OutputFields() {}

  private static Map<String, OutputField> fields() {
    Map<String, OutputField> fields = new LinkedHashMap<>();
    for (StateQuantity quantity : StateQuantities.all()) {
      List<String> names = quantity.rtdeNames();
      for (int i = 0; i < names.size(); i++) {
        if (!names.get(i).isEmpty()) {
          OutputField field =
              quantity.fieldEach()
                  ? new OutputField(names.get(i), quantity, i, 1)
                  : new OutputField(names.get(i), quantity, 0, quantity.size());
          fields.put(field.name(), field);
        }
      }
    }
    return Collections.unmodifiableMap(fields);
  }

  /** The field called {@code name}, such as {@code actual_q}; empty if there is none. */
  public static Optional<OutputField> of(String name) {
    return Optional.ofNullable(FIELDS.get(name));
  }

  /** All fields. */
  public static Collection<OutputField> all() {
    return FIELDS.values();
  }
}
