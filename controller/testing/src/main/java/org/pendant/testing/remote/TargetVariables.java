package org.pendant.testing.remote;

import java.util.Map;
import org.pendant.script.value.Value;

/**
 * Target variables: the global variables that a target tells of its program, a few times a second.
 *
 * @param begun how often it has begun to tell them
 * @param whole how often it has told them, to the end
 * @param values by name, those that have one; strings are bytes, one {@code char} a byte
 */
public record TargetVariables(long begun, long whole, Map<String, Value> values) {
  /** Nothing is told yet. */
  public static final TargetVariables NONE = new TargetVariables(0, 0, Map.of());

  public TargetVariables {
    values = Map.copyOf(values);
  }
}
