package org.pendant.project.program;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;

/** Unit in which forms show a number, and so also what is said about it; inside it is SI. */
public enum FieldUnit {
  MILLIMETRE("mm", 1e-3),
  MILLIMETRE_PER_S("mm/s", 1e-3),
  MILLIMETRE_PER_S2("mm/s²", 1e-3),
  DEGREE("deg", Math.PI / 180),
  DEGREE_PER_S("deg/s", Math.PI / 180),
  DEGREE_PER_S2("deg/s²", Math.PI / 180),
  SECOND("s", 1),
  NEWTON("N", 1),
  NEWTON_METRE("Nm", 1),
  KILOGRAM("kg", 1),
  VOLT("V", 1),
  MILLIAMPERE("mA", 1e-3),
  /** A whole number of things. */
  COUNT("", 1),
  /** A number without a unit. */
  NUMBER("", 1);

  /** As many as forms show at most. */
  private static final int DECIMALS = 3;

  private static final MathContext TINY = new MathContext(2);

  private final String symbol;
  private final double factor;

  FieldUnit(String symbol, double factor) {
    this.symbol = symbol;
    this.factor = factor;
  }

  /** Behind a number; empty for none. */
  public String symbol() {
    return symbol;
  }

  /** A number in SI as the form shows it, without the unit. */
  public String number(double value) {
    if (!Double.isFinite(value)) {
      return String.valueOf(value);
    }
    BigDecimal exact = new BigDecimal(value / factor);
    BigDecimal brief = exact.setScale(DECIMALS, RoundingMode.HALF_EVEN);
    boolean lost = brief.signum() == 0 && exact.signum() != 0;
    return (lost ? exact.round(TINY) : brief).stripTrailingZeros().toPlainString();
  }

  /** As {@link #number}, with the unit. */
  public String words(double value) {
    return symbol.isEmpty() ? number(value) : number(value) + " " + symbol;
  }
}
