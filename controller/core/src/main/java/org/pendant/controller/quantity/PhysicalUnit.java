package org.pendant.controller.quantity;

/** The unit of a quantity's numbers. */
public enum PhysicalUnit {
  /** Counts, codes, bits and whatever programs keep in registers. */
  NONE(""),
  /** A part of a whole, 0 to 1. */
  RATIO(""),
  /** A level, 0 or 1. */
  LEVEL(""),
  SECOND("s"),
  MILLISECOND("ms"),
  METRE("m"),
  METRE_PER_SECOND("m/s"),
  METRE_PER_SECOND_SQUARED("m/s²"),
  RADIAN("rad"),
  RADIAN_PER_SECOND("rad/s"),
  RADIAN_PER_SECOND_SQUARED("rad/s²"),
  KILOGRAM("kg"),
  KILOGRAM_METRE_SQUARED("kg m²"),
  KILOGRAM_METRE_PER_SECOND("kg m/s"),
  NEWTON("N"),
  NEWTON_METRE("Nm"),
  JOULE("J"),
  VOLT("V"),
  AMPERE("A"),
  /** Ampere or volt, as the domain of the analog signal says. */
  AMPERE_OR_VOLT("A or V"),
  CELSIUS("°C");

  private final String symbol;

  PhysicalUnit(String symbol) {
    this.symbol = symbol;
  }

  /** Its symbol; empty where none is written. */
  public String symbol() {
    return symbol;
  }
}
