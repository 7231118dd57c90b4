package org.pendant.controller.rtde;

import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;

/**
 * Every field that RTDE clients may read, by topic. Units are those of the SI, currents in A,
 * temperatures in degrees Celsius, execution times in microseconds; poses and what belongs to the
 * TCP are in the base frame.
 */
public final class OutputFields {
  /** The field that says how long the computer works at a frame. */
  public static final String EXECUTION_TIME = "actual_execution_time";

  private static final Map<String, OutputField> FIELDS = catalogue();

  private OutputFields() {}

  private static Map<String, OutputField> catalogue() {
    Map<String, OutputField> fields = new LinkedHashMap<>();
    FieldList list = new FieldList(fields);
    ArmFields.addTo(list);
    StateFields.addTo(list);
    SignalFields.addTo(list);
    RegisterFields.addTo(list);
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
