package org.pendant.sweep.plan;

import java.util.List;

/**
 * Variant of a sweep.
 *
 * @param number from 0
 * @param values one for each parameter of the plan, in their order
 */
public record SweepVariant(long number, List<ParameterValue> values) {
  /** Copies the list. */
  public SweepVariant {
    values = List.copyOf(values);
  }
}
