package org.pendant.desktop.workbench;

import org.pendant.controller.quantity.PhysicalUnit;

/**
 * Screen unit in which people see a quantity: degrees, millimetres and percents.
 *
 * @param symbol empty where none is written
 * @param scale how many of it one unit of the controller is
 */
public record ScreenUnit(String symbol, double scale) {
  /** That of levels. */
  public static final String LEVEL = "0/1";

  private static final double DEGREES = Math.toDegrees(1);
  private static final double MILLI = 1e3;

  /** What a unit of the controller becomes. */
  public static ScreenUnit of(PhysicalUnit unit) {
    return switch (unit) {
      case RADIAN -> new ScreenUnit("\u00b0", DEGREES);
      case RADIAN_PER_SECOND -> new ScreenUnit("\u00b0/s", DEGREES);
      case RADIAN_PER_SECOND_SQUARED -> new ScreenUnit("\u00b0/s\u00b2", DEGREES);
      case METRE -> new ScreenUnit("mm", MILLI);
      case METRE_PER_SECOND -> new ScreenUnit("mm/s", MILLI);
      case RATIO -> new ScreenUnit("%", 100);
      case LEVEL -> new ScreenUnit(LEVEL, 1);
      case AMPERE_OR_VOLT -> new ScreenUnit(WorkbenchTexts.text("voltOrMilliampere"), 1);
      case NONE,
          SECOND,
          MILLISECOND,
          METRE_PER_SECOND_SQUARED,
          KILOGRAM,
          KILOGRAM_METRE_SQUARED,
          KILOGRAM_METRE_PER_SECOND,
          NEWTON,
          NEWTON_METRE,
          JOULE,
          VOLT,
          AMPERE,
          CELSIUS ->
          new ScreenUnit(unit.symbol(), 1);
    };
  }

  /** A number as text behind which the unit stands. */
  public String after(String number) {
    return symbol.equals("\u00b0") ? number + symbol : number + " " + symbol;
  }
}
