package org.pendant.desktop.scene.view;

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
    return switch (margin) {
      case JOINT_SPEED, TORQUE, TOOL_SPEED ->
          new TraceScale(
              "\u2264 " + Math.round(100 * margin.ample()) + " %", "", "100 % " + margin.words());
      case JOINT_LIMIT ->
          new TraceScale("\u2265 " + angle(margin.ample(), form), "", "at a joint limit");
      case PLANE -> {
        Measure unit = ShownMeasure.of(Measure.MILLIMETRE, form);
        yield new TraceScale(
            "\u2265 " + number(unit.shown(margin.ample())) + " " + unit.symbol(), "", "at a plane");
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
