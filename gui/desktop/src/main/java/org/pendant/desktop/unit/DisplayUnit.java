package org.pendant.desktop.unit;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Display unit: in what people read and type numbers; everything else counts in m, rad, kg and kg
 * m².
 */
public enum DisplayUnit {
  MILLIMETRE(Kind.LENGTH, "mm", 1e-3, 2),
  METRE(Kind.LENGTH, "m", 1, 5),
  INCH(Kind.LENGTH, "in", 0.0254, 4),
  DEGREE(Kind.ANGLE, "deg", Math.PI / 180, 3),
  RADIAN(Kind.ANGLE, "rad", 1, 5),
  KILOGRAM(Kind.MASS, "kg", 1, 3),
  GRAM(Kind.MASS, "g", 1e-3, 0),
  KILOGRAM_SQUARE_METRE(Kind.INERTIA, "kg\u00b7m\u00b2", 1, 5);

  /** What is counted. */
  public enum Kind {
    LENGTH,
    ANGLE,
    MASS,
    INERTIA
  }

  private static final Pattern NUMBER =
      Pattern.compile("([+-]?(?:\\d+[.,]?\\d*|[.,]\\d+)(?:[eE][+-]?\\d+)?)\\s*(\\S*)");

  private final Kind kind;
  private final String symbol;
  private final double factor;
  private final int decimals;

  DisplayUnit(Kind kind, String symbol, double factor, int decimals) {
    this.kind = kind;
    this.symbol = symbol;
    this.factor = factor;
    this.decimals = decimals;
  }

  /** What stands behind numbers, such as {@code mm}. */
  public String symbol() {
    return symbol;
  }

  /** Its name in the plural, such as {@code millimetres}. */
  public String title() {
    return this == INCH ? "inches" : name().toLowerCase(Locale.ROOT).replace('_', ' ') + "s";
  }

  /** The units for one kind of number. */
  public static List<DisplayUnit> of(Kind kind) {
    return Arrays.stream(values()).filter(each -> each.kind == kind).toList();
  }

  /** The unit with this symbol, if it is one of {@code kind}. */
  public static Optional<DisplayUnit> of(Kind kind, String symbol) {
    return of(kind).stream().filter(each -> each.symbol.equals(symbol)).findAny();
  }

  /** A number in m, rad or kg as people read it, without the symbol. */
  public String text(double value) {
    String text = String.format(Locale.ROOT, "%." + decimals + "f", value / factor);
    return unsigned(text);
  }

  /** Without a sign before a zero. */
  private static String unsigned(String text) {
    return text.matches("-0(\\.0*)?") ? text.substring(1) : text;
  }

  /** A number that was measured, with its unit: of degrees two decimals are enough. */
  public String reading(double value) {
    return this == DEGREE
        ? unsigned(String.format(Locale.ROOT, "%.2f", value / factor)) + "\u00b0"
        : text(value) + " " + symbol;
  }

  /** As {@link #text}, without decimals that are 0. */
  public String shortText(double value) {
    String text = text(value);
    return text.contains(".") ? text.replaceAll("\\.?0+$", "") : text;
  }

  /**
   * Reads what the user typed: a number, a point or a comma before its decimals, and if they like a
   * unit of the same kind; without one it is in this unit.
   *
   * @return the number in m, rad or kg
   * @throws IllegalArgumentException with a sentence for people if it is none
   */
  public double parse(String text) {
    Matcher parts = NUMBER.matcher(text.strip());
    if (!parts.matches()) {
      throw new IllegalArgumentException(
          text.isBlank()
              ? UnitTexts.text("emptyMustBeANumberIn", symbol)
              : UnitTexts.text("isNotANumberWriteFor", text.strip(), symbol));
    }
    String typed = parts.group(2).equals("\u00b0") ? "deg" : parts.group(2);
    DisplayUnit unit = typed.isEmpty() ? this : unitOf(typed);
    return Double.parseDouble(parts.group(1).replace(',', '.')) * unit.factor;
  }

  private DisplayUnit unitOf(String typed) {
    return of(kind, typed)
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    UnitTexts.text(
                        "unitIsMustBe",
                        typed,
                        of(kind).stream()
                            .map(DisplayUnit::symbol)
                            .reduce((one, other) -> UnitTexts.text("or", one, other))
                            .orElseThrow())));
  }

  @Override
  public String toString() {
    return symbol;
  }
}
