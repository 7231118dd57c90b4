package org.pendant.kit.form;

import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Measure: in what a form shows and takes numbers; inside they count in SI. */
public enum Measure {
  MILLIMETRE("mm", 1e-3, 3),
  METRE("m", 1, 6),
  INCH("in", 0.0254, 4),
  MILLIMETRE_PER_S("mm/s", 1e-3, 3),
  MILLIMETRE_PER_S2("mm/s\u00b2", 1e-3, 3),
  METRE_PER_S("m/s", 1, 6),
  METRE_PER_S2("m/s\u00b2", 1, 6),
  INCH_PER_S("in/s", 0.0254, 4),
  INCH_PER_S2("in/s\u00b2", 0.0254, 4),
  DEGREE("deg", Math.PI / 180, 3),
  RADIAN("rad", 1, 6),
  DEGREE_PER_S("deg/s", Math.PI / 180, 3),
  DEGREE_PER_S2("deg/s\u00b2", Math.PI / 180, 3),
  RADIAN_PER_S("rad/s", 1, 6),
  RADIAN_PER_S2("rad/s\u00b2", 1, 6),
  SECOND("s", 1, 3),
  NEWTON("N", 1, 2),
  NEWTON_METRE("Nm", 1, 3),
  NEWTON_PER_METRE("N/m", 1, 0),
  NEWTON_SECOND_PER_METRE("N s/m", 1, 2),
  SECOND_PER_METRE("s/m", 1, 3),
  KILOGRAM("kg", 1, 3),
  VOLT("V", 1, 3),
  MILLIAMPERE("mA", 1e-3, 3),
  KILOGRAM_METRE_PER_S("kg m/s", 1, 3),
  KILOGRAM_METRE2("kg m\u00b2", 1, 6),
  WATT("W", 1, 2),
  HERTZ("Hz", 1, 0),
  COUNT("", 1, 0),
  PLAIN("", 1, 4);

  private static final Pattern NUMBER =
      Pattern.compile("([+-]?(?:\\d+[.,]?\\d*|[.,]\\d+)(?:[eE][+-]?\\d{1,3})?)\\s*(\\S*)");

  /** Digits of a number that gives an idea; a limit is not made larger. */
  private static final MathContext BRIEF = new MathContext(4, RoundingMode.DOWN);

  private final String symbol;
  private final double factor;
  private final int decimals;

  Measure(String symbol, double factor, int decimals) {
    this.symbol = symbol;
    this.factor = factor;
    this.decimals = decimals;
  }

  /** Behind the field; empty for plain numbers. */
  public String symbol() {
    return symbol;
  }

  /** A number in SI in this measure. */
  public double shown(double value) {
    return value / factor;
  }

  /** A number in SI as people read it, without the symbol and without decimals that are 0. */
  public String text(double value) {
    String text = String.format(Locale.ROOT, "%." + decimals + "f", value / factor);
    String brief = text.contains(".") ? text.replaceAll("\\.?0+$", "") : text;
    return brief.equals("-0") ? "0" : brief;
  }

  /** A limit in few digits, to have an idea of it. */
  public String brief(double value) {
    double shown = value / factor;
    return Math.abs(shown) < 100
        ? new BigDecimal(text(value)).round(BRIEF).stripTrailingZeros().toPlainString()
        : String.format(Locale.ROOT, "%.0f", Math.floor(Math.abs(shown)) * Math.signum(shown));
  }

  /** As {@link #text}, with the symbol. */
  public String words(double value) {
    return symbol.isEmpty() ? text(value) : text(value) + " " + symbol;
  }

  /**
   * Reads what the user typed: a number with a point or a comma, and the unit if they like.
   *
   * @return the number in SI
   * @throws IllegalArgumentException with a sentence for people if it is none
   */
  public double parse(String text) {
    String typed = text.strip();
    Matcher parts = NUMBER.matcher(typed);
    if (typed.isEmpty()) {
      throw new IllegalArgumentException(
          symbol.isEmpty()
              ? FormFieldTexts.text("emptyMustBeNumber")
              : FormFieldTexts.text("emptyMustBeNumberIn", symbol));
    }
    if (!parts.matches()) {
      throw new IllegalArgumentException(
          symbol.isEmpty()
              ? FormFieldTexts.text("notANumber", typed)
              : FormFieldTexts.text("notANumberIn", typed, symbol));
    }
    String typedUnit = plain(parts.group(2));
    if (!typedUnit.isEmpty() && !typedUnit.equals(plain(symbol))) {
      throw new IllegalArgumentException(
          symbol.isEmpty()
              ? FormFieldTexts.text("unitMustBeNone", parts.group(2))
              : FormFieldTexts.text("unitMustBe", parts.group(2), symbol));
    }
    double number = Double.parseDouble(parts.group(1).replace(',', '.'));
    if (this == COUNT && number != Math.rint(number)) {
      throw new IllegalArgumentException(FormFieldTexts.text("notAWholeNumber", typed));
    }
    return number * factor;
  }

  private static String plain(String unit) {
    return unit.replace("\u00b0", "deg").replace("\u00b2", "2");
  }
}
