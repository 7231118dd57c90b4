package org.pendant.project.program;

import static org.pendant.project.program.ProgramTreeTexts.text;

import java.util.function.DoubleFunction;

/**
 * Range of the numbers that a field may have, in SI.
 *
 * @param min the smallest
 * @param max the largest
 * @param open whether {@code min} itself is not legal
 */
public record NumberRange(double min, double max, boolean open) {
  /** Any number. */
  public static final NumberRange ANY =
      new NumberRange(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY, false);

  /** More than 0, and at most a number. */
  public static NumberRange upTo(double max) {
    return new NumberRange(0, max, true);
  }

  /** From one number to another, both of which are legal. */
  public static NumberRange of(double min, double max) {
    return new NumberRange(min, max, false);
  }

  /** From as far below 0 as above it. */
  public static NumberRange within(double most) {
    return of(-most, most);
  }

  /** Whether a number is legal. */
  public boolean contains(double value) {
    return Double.isFinite(value) && (open ? value > min : value >= min) && value <= max;
  }

  /** What is legal, such as {@code must be above 0 and at most 250 mm/s}. */
  public String words(FieldUnit unit) {
    return words(unit::number, unit.symbol());
  }

  /** As {@link #words(FieldUnit)}, in any unit. */
  public String words(DoubleFunction<String> number, String symbol) {
    if (equals(ANY)) {
      return text("mustBeNumber");
    }
    String most = symbol.isEmpty() ? number.apply(max) : number.apply(max) + " " + symbol;
    return open
        ? text("mustBeAbove", number.apply(min), most)
        : text("mustBeWithin", number.apply(min), most);
  }
}
