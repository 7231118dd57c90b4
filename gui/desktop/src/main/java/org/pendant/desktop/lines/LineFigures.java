package org.pendant.desktop.lines;

import static org.pendant.desktop.lines.LineTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.IntFunction;
import org.pendant.desktop.editor.LineNote;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.recording.lines.LineStatistics;
import org.pendant.recording.lines.Margin;
import org.pendant.recording.lines.RunProfile;
import org.pendant.recording.lines.Worst;

/** Line figures: what a line took of a run, as people read it. */
final class LineFigures {
  private final PoseForm units;

  LineFigures(PoseForm units) {
    this.units = units;
  }

  /**
   * What stands beside a line.
   *
   * @param share of the time of the run
   */
  LineNote note(LineStatistics line, double share) {
    return new LineNote(parts(line), share, heat(line, share), whole(line, share));
  }

  private List<String> parts(LineStatistics line) {
    List<String> parts = new ArrayList<>();
    boolean often = line.executions() > 1;
    parts.add(timeText(line.timeS()));
    if (often) {
      parts.add(line.executions() + "\u00d7");
    }
    if (line.moved()) {
      parts.add(way(line.pathM()));
      line.worst(Margin.JOINT_SPEED).ifPresent(each -> parts.add(text("speed", share(each))));
      line.worst(Margin.TORQUE).ifPresent(each -> parts.add(text("torque", share(each))));
      line.worst(Margin.PLANE).ifPresent(each -> parts.add(plane(each)));
      line.worst(Margin.JOINT_LIMIT).ifPresent(each -> parts.add(limit(each)));
    }
    if (often) {
      parts.add(text("longest", timeText(line.longestS())));
    }
    return parts;
  }

  private static String heat(LineStatistics line, double share) {
    return text(
        line.executions() == 1 ? "ofTheCycle" : "ofTheCycleInExecutions",
        String.format(Locale.ROOT, "%.0f", 100 * share),
        timeText(line.timeS()),
        line.executions());
  }

  private String whole(LineStatistics line, double share) {
    List<String> rows = new ArrayList<>();
    rows.add(heat(line, share));
    if (line.executions() > 1) {
      rows.add(text("longestExecution", timeText(line.longestS())));
    }
    if (line.moved()) {
      rows.add(text("wayOfTheTool", way(line.pathM())));
      rows.add(text("highestSpeedOfTheToolS", way(line.toolSpeedMPerS())));
    }
    line.worst(Margin.JOINT_SPEED)
        .ifPresent(each -> rows.add(text("highestJointSpeed", ofLimit(each))));
    line.worst(Margin.TORQUE).ifPresent(each -> rows.add(text("highestTorque", ofLimit(each))));
    line.worst(Margin.JOINT_LIMIT)
        .ifPresent(each -> rows.add(text("nearestJointLimit", each.part(), angle(each.value()))));
    line.worst(Margin.PLANE)
        .ifPresent(each -> rows.add(text("nearestSafetyPlane", each.part(), way(each.value()))));
    return String.join("\n", rows);
  }

  /**
   * What a worst moment of a run is called.
   *
   * @param place what a line is called in a sentence
   */
  String moment(RunProfile.Moment moment, IntFunction<String> place) {
    Worst each = moment.worst();
    String what =
        switch (each.margin()) {
          case JOINT_SPEED -> text("highestJointSpeedInSentence", share(each));
          case TORQUE -> text("highestTorqueInSentence", share(each));
          case JOINT_LIMIT -> text("nearestToAJointLimit", limit(each));
          case PLANE -> text("nearestToASafetyPlane", plane(each));
          case TOOL_SPEED ->
              String.format(Locale.ROOT, text("fastestToolOfTheSafetyLimit"), 100 * each.value());
        };
    return what + " (" + place.apply(moment.line()) + ")";
  }

  private static String ofLimit(Worst each) {
    return String.format(Locale.ROOT, text("ofItsLimit"), each.part(), 100 * each.value());
  }

  private static String share(Worst each) {
    return String.format(Locale.ROOT, "%.0f %% ", 100 * each.value()) + each.part();
  }

  private String plane(Worst each) {
    return each.value() < 0
        ? text("beyond", way(-each.value()), each.part())
        : text("toPlane", way(each.value()), each.part());
  }

  private String limit(Worst each) {
    return text("toTheLimitOf", angle(each.value()), each.part());
  }

  /** A time as it is read with ease: three digits or four. */
  static String timeText(double timeS) {
    String form = timeS < 1 ? "%.3f s" : timeS < 100 ? "%.2f s" : "%.1f s";
    return String.format(Locale.ROOT, form, timeS);
  }

  /** A length in the unit of the window. */
  String way(double lengthM) {
    DisplayUnit unit = units.length();
    boolean small = unit == DisplayUnit.MILLIMETRE && Math.abs(lengthM) < 0.01;
    int decimals =
        switch (unit) {
          case METRE -> 4;
          case INCH -> 2;
          default -> small ? 1 : 0;
        };
    return Optional.of(unit.text(lengthM))
        .map(Double::parseDouble)
        .map(value -> String.format(Locale.ROOT, "%." + decimals + "f ", value))
        .map(text -> text + unit.symbol())
        .get();
  }

  /** As {@link #angle}, with the digits of a speed. */
  String turn(double angleRad) {
    return units.angle() == DisplayUnit.RADIAN
        ? String.format(Locale.ROOT, "%.3f rad", angleRad)
        : String.format(Locale.ROOT, "%.1f\u00b0", Math.toDegrees(angleRad));
  }

  /** An angle in the unit of the window. */
  String angle(double angleRad) {
    return units.angle() == DisplayUnit.RADIAN
        ? String.format(Locale.ROOT, "%.2f rad", angleRad)
        : String.format(Locale.ROOT, "%.0f\u00b0", Math.toDegrees(angleRad));
  }
}
