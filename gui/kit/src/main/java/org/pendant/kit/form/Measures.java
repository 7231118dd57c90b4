package org.pendant.kit.form;

/**
 * Measures: in which people want to see what usually is in another; asked again when forms show.
 */
@FunctionalInterface
public interface Measures {
  /** Everything as it usually is. */
  Measures USUAL = usual -> usual;

  /** The one that people want instead of {@code usual}; of the same kind. */
  Measure of(Measure usual);
}
