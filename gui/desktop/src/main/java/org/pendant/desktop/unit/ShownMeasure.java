package org.pendant.desktop.unit;

import org.pendant.kit.form.Measure;
import org.pendant.kit.form.Measures;
import org.pendant.kit.settings.Settings;

/**
 * Shown measure: the units that people have chosen for lengths and angles, for all that has them.
 */
public final class ShownMeasure {
  private ShownMeasure() {}

  /** Those that are chosen now, whenever that is asked. */
  public static Measures by(Settings settings) {
    return usual -> of(usual, FormMemory.read(settings));
  }

  /** What stands for {@code usual}, which is in millimetres, degrees or something else. */
  public static Measure of(Measure usual, PoseForm form) {
    return switch (usual) {
      case MILLIMETRE -> length(form, Measure.MILLIMETRE, Measure.METRE, Measure.INCH);
      case MILLIMETRE_PER_S ->
          length(form, Measure.MILLIMETRE_PER_S, Measure.METRE_PER_S, Measure.INCH_PER_S);
      case MILLIMETRE_PER_S2 ->
          length(form, Measure.MILLIMETRE_PER_S2, Measure.METRE_PER_S2, Measure.INCH_PER_S2);
      case DEGREE -> angle(form, Measure.DEGREE, Measure.RADIAN);
      case DEGREE_PER_S -> angle(form, Measure.DEGREE_PER_S, Measure.RADIAN_PER_S);
      case DEGREE_PER_S2 -> angle(form, Measure.DEGREE_PER_S2, Measure.RADIAN_PER_S2);
      case METRE,
          METRE_PER_S,
          METRE_PER_S2,
          INCH,
          INCH_PER_S,
          INCH_PER_S2,
          RADIAN,
          RADIAN_PER_S,
          RADIAN_PER_S2,
          SECOND,
          NEWTON,
          NEWTON_METRE,
          NEWTON_PER_METRE,
          NEWTON_SECOND_PER_METRE,
          SECOND_PER_METRE,
          KILOGRAM,
          VOLT,
          MILLIAMPERE,
          KILOGRAM_METRE_PER_S,
          KILOGRAM_METRE2,
          WATT,
          HERTZ,
          COUNT,
          PLAIN ->
          usual;
    };
  }

  private static Measure length(
      PoseForm form, Measure millimetres, Measure metres, Measure inches) {
    return switch (form.length()) {
      case METRE -> metres;
      case INCH -> inches;
      case MILLIMETRE, DEGREE, RADIAN, KILOGRAM, GRAM, KILOGRAM_SQUARE_METRE -> millimetres;
    };
  }

  private static Measure angle(PoseForm form, Measure degrees, Measure radians) {
    return form.angle() == DisplayUnit.RADIAN ? radians : degrees;
  }
}
