package org.pendant.project.program;

import java.util.Optional;
import java.util.OptionalDouble;

/**
 * Field of a node that holds a number. Its check, its form and new nodes all read it here; {@link
 * NodeFields} has all of them. A range is the same for every arm, as a program runs on several.
 *
 * @param name the component of the step's record, and after points what is within it, such as
 *     {@code speed} or {@code rule.distanceM}
 * @param words what messages call it
 * @param unit in which people read and type it
 * @param range of its values, in SI
 * @param initial what it is at first, in SI; empty for a number that there need not be
 */
public record NodeField(
    String name, String words, FieldUnit unit, NumberRange range, OptionalDouble initial) {
  NodeField(String name, String words, FieldUnit unit, NumberRange range, double initial) {
    this(name, words, unit, range, OptionalDouble.of(initial));
  }

  /** The same field of another component. */
  NodeField named(String other) {
    return new NodeField(other, words, unit, range, initial);
  }

  /** The same field with another value at first. */
  NodeField from(double first) {
    return new NodeField(name, words, unit, range, first);
  }

  /** The same field where there need not be a number. */
  NodeField optional() {
    return new NodeField(name, words, unit, range, OptionalDouble.empty());
  }

  /** The component of the step's record that it is or belongs to. */
  public String component() {
    int point = name.indexOf('.');
    return point < 0 ? name : name.substring(0, point);
  }

  /**
   * What it is at first, in SI.
   *
   * @throws java.util.NoSuchElementException if there is no number at first
   */
  public double initialValue() {
    return initial.orElseThrow();
  }

  /** Why a number, in SI, is not legal, such as {@code must be 0 to 10 V}; empty if it is. */
  public Optional<String> refusal(double value) {
    return range.contains(value) ? Optional.empty() : Optional.of(range.words(unit));
  }
}
