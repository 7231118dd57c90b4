package org.pendant.desktop.scene.view;

import static org.pendant.desktop.scene.view.PictureTexts.text;

import java.math.BigDecimal;
import java.math.MathContext;
import org.pendant.desktop.scene.TcpTrace;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.desktop.unit.ShownMeasure;
import org.pendant.kit.form.Measure;
import org.pendant.recording.lines.Margin;

/**
 * Trace scale: what the colours of a trace mean: at both ends, and at half way where there is room.
 */
record TraceScale(String least, String middle, String most) {
  private static final MathContext DIGITS = new MathContext(3);

  /**
   * That of a trace.
   *
   * @param form in whose units it is written
   */
  static TraceScale of(TcpTrace trace, PoseForm form) {
    return trace
        .colouring()
        .map(margin -> of(margin, form))
        .orElseGet(() -> speeds(trace.scaleMPerS(), form));
  }

  private static TraceScale speeds(double mostMPerS, PoseForm form) {
    Measure unit = ShownMeasure.of(Measure.MILLIMETRE_PER_S, form);
    return new TraceScale("0", number(unit.shown(mostMPerS / 4)), speed(mostMPerS, form));
  }

  /** A speed in three digits. */
  static String speed(double speedMPerS, PoseForm form) {
    Measure unit = ShownMeasure.of(Measure.MILLIMETRE_PER_S, form);
    return number(unit.shown(speedMPerS)) + " " + unit.symbol();
  }

  private static TraceScale of(Margin margin, PoseForm form) {
    return new TraceScale(
        bounded(margin, 0, form),
        "",
        switch (margin) {
          case JOINT_SPEED, TORQUE, TOOL_SPEED -> "100 % " + margin.words();
          case JOINT_LIMIT -> text("atAJointLimit");
          case PLANE -> text("atAPlane");
        });
  }

  /**
   * How near the arm was to a limit, such as {@code torque 62 %}, {@code safety plane: 12 mm away}.
   *
   * @param used how much of the margin, 0 to 1: at both ends it is only known that it is not less,
   *     or not more
   */
  static String margin(Margin margin, double used, PoseForm form) {
    String value = bounded(margin, used, form);
    return margin.isShare() ? margin.words() + " " + value : text("away", margin.words(), value);
  }

  private static String bounded(Margin margin, double used, PoseForm form) {
    boolean ample = used <= 0;
    boolean tight = used >= 1;
    boolean atMost = margin.isShare() ? ample : tight;
    boolean atLeast = margin.isShare() ? tight : ample;
    return (atMost ? "\u2264 " : atLeast ? "\u2265 " : "")
        + value(margin, margin.valueAt(used), form);
  }

  private static String value(Margin margin, double value, PoseForm form) {
    return switch (margin) {
      case JOINT_SPEED, TORQUE, TOOL_SPEED -> Math.round(100 * value) + " %";
      case JOINT_LIMIT -> angle(value, form);
      case PLANE -> {
        Measure unit = ShownMeasure.of(Measure.MILLIMETRE, form);
        yield number(unit.shown(value)) + " " + unit.symbol();
      }
    };
  }

  private static String angle(double rad, PoseForm form) {
    return form.angle() == DisplayUnit.RADIAN
        ? number(rad) + " rad"
        : Math.round(Math.toDegrees(rad)) + "\u00b0";
  }

  private static String number(double value) {
    return new BigDecimal(value).round(DIGITS).stripTrailingZeros().toPlainString();
  }
}
