package org.pendant.desktop.editor.text;

import java.util.Locale;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.unit.ShownMeasure;
import org.pendant.kit.form.Measure;
import org.pendant.language.service.Quantity;
import org.pendant.language.signature.Unit;

/** Quantity text: a number of a script in the units that people think in. */
final class QuantityText {
  private QuantityText() {}

  /** Such as {@code a: 1.4 rad/s² = 80.2°/s²}. */
  static String of(Quantity quantity, PoseForm form) {
    String written = plain(quantity.value());
    Unit unit = quantity.unit();
    String own = quantity.name() + ": " + written + " " + unit.symbol();
    return switch (unit) {
      case RADIAN, RADIAN_PER_SECOND, RADIAN_PER_SECOND_SQUARED ->
          form.angle() == DisplayUnit.RADIAN
              ? own
              : own
                  + " = "
                  + rounded(Math.toDegrees(quantity.value()))
                  + "\u00b0"
                  + unit.symbol().substring("rad".length());
      case METRE, METRE_PER_SECOND, METRE_PER_SECOND_SQUARED -> {
        Measure length = ShownMeasure.of(Measure.MILLIMETRE, form);
        yield length == Measure.METRE
            ? own
            : own
                + " = "
                + rounded(length.shown(quantity.value()))
                + " "
                + length.symbol()
                + unit.symbol().substring("m".length());
      }
      case DEGREE -> own + " = " + plain(Math.toRadians(quantity.value())) + " rad";
      case SECOND -> own + " = " + rounded(quantity.value() * 1000) + " ms";
      case NONE, KILOGRAM, NEWTON, NEWTON_METRE, VOLT, AMPERE, HERTZ, CELSIUS -> own;
    };
  }

  private static String plain(double value) {
    return value == Math.rint(value) && Math.abs(value) < 1e9
        ? Long.toString((long) value)
        : String.format(Locale.ROOT, "%.5g", value).replaceAll("\\.?0+$", "");
  }

  private static String rounded(double value) {
    return String.format(Locale.ROOT, Math.abs(value) < 1 ? "%.3f" : "%.1f", value);
  }
}
