package org.pendant.sweep.engine;

import org.pendant.sweep.plan.SweepVariant;

/** Variant source: tells variants by their numbers; any thread. */
@FunctionalInterface
public interface VariantSource {
  /** The variant of a number. */
  SweepVariant variant(long number);
}
