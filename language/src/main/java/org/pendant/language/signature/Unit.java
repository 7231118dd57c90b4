package org.pendant.language.signature;

/** The unit of a numeric parameter or result. */
public enum Unit {
  NONE(""),
  METRE("m"),
  METRE_PER_SECOND("m/s"),
  METRE_PER_SECOND_SQUARED("m/s²"),
  RADIAN("rad"),
  RADIAN_PER_SECOND("rad/s"),
  RADIAN_PER_SECOND_SQUARED("rad/s²"),
  DEGREE("deg"),
  SECOND("s"),
  KILOGRAM("kg"),
  NEWTON("N"),
  NEWTON_METRE("Nm"),
  VOLT("V"),
  AMPERE("A"),
  HERTZ("Hz"),
  CELSIUS("°C");

  private final String symbol;

  Unit(String symbol) {
    this.symbol = symbol;
  }

  public String symbol() {
    return symbol;
  }
}
