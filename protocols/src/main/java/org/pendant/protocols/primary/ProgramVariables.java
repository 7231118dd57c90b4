package org.pendant.protocols.primary;

import java.util.Map;
import org.pendant.script.value.Value;

/**
 * Program variables: the global variables that a controller has told of its program. Several
 * packages may tell them, about ten times a second, changed or not.
 *
 * @param begun how often it has begun to tell them
 * @param whole how often it had, when it last went on to something else
 * @param values by name, as they were told then, those that have one; strings are bytes, one {@code
 *     char} a byte
 */
public record ProgramVariables(long begun, long whole, Map<String, Value> values) {
  /** Nothing is told yet. */
  public static final ProgramVariables NONE = new ProgramVariables(0, 0, Map.of());

  public ProgramVariables {
    values = Map.copyOf(values);
  }
}
