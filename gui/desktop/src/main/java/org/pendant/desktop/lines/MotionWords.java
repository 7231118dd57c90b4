package org.pendant.desktop.lines;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.IntFunction;
import org.pendant.controller.safety.SpeedUse;
import org.pendant.controller.state.ArmState;
import org.pendant.desktop.unit.DisplayUnit;
import org.pendant.desktop.unit.PoseForm;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.recording.explain.Cause;
import org.pendant.recording.explain.MotionExplanation;

/** Motion words: why the arm moved as it did, as people read it. */
final class MotionWords {
  private static final List<String> JOINTS =
      List.of("Base", "Shoulder", "Elbow", "Wrist 1", "Wrist 2", "Wrist 3");

  /** Limits of which less is used say nothing about the speed. */
  private static final double WORTH_TELLING = 0.05;

  private static final int MAX_LIMITS = 3;

  private final PoseForm units;
  private final LineFigures figures;

  MotionWords(PoseForm units) {
    this.units = units;
    figures = new LineFigures(units);
  }

  /**
   * A row of numbers.
   *
   * @param planned where the controller wanted it
   */
  record Row(String name, String planned, String actual, String difference) {}

  /**
   * When and where in the program.
   *
   * @param place what a line is called in a sentence
   */
  String place(MotionExplanation moment, IntFunction<String> place) {
    int line = moment.now().program().line();
    String time = String.format(Locale.ROOT, "%.3f s", moment.now().timeS());
    return time
        + (line == 0 ? ", no program runs" : ", " + place.apply(line) + ": " + moment.text());
  }

  /** What set the speed. */
  String cause(MotionExplanation moment) {
    Cause cause = moment.cause();
    boolean joints = moment.text().contains("movej");
    String sentence =
        switch (cause.kind()) {
          case REST -> "The arm rests.";
          case HAND -> "A hand guides the arm.";
          case TORQUE -> "Torques of the program drive the arm.";
          case SAFETY_STOP -> "A safety stop brings the arm to rest.";
          case PAUSE -> "The program is paused: the arm comes to rest on its path.";
          case START_RAMP -> "The start ramp: moves come up to speed in the first 0.160 s.";
          case SAFETY_LIMIT -> "Slowed down by a limit: " + use(cause.use().orElseThrow()) + ".";
          case SCALING_RAMP ->
              "The speed is changing to what slider, pause and limits let it have, in a ramp.";
          case SCALING ->
              String.format(
                  Locale.ROOT,
                  "Slowed down to %.0f %% by something that frames do not tell, such as the"
                      + " program itself or the singularity that is near.",
                  100 * cause.value());
          case COMMAND_SPEED ->
              "Full speed of the command: " + speed(cause.value(), joints) + slider(moment) + ".";
          case COMMAND_TIME ->
              "Steady, at the speed that makes the move take as long as the command says: "
                  + speed(cause.value(), joints)
                  + slider(moment)
                  + ".";
          case STREAMED -> "The program sets the speed itself, by this command.";
          case JOINT_LIMIT ->
              slower(cause, joints) + use(cause.use().orElseThrow()) + ", as fast as it can turn.";
          case SHORT_WAY ->
              slower(cause, joints) + "the way is too short, and the arm slows down from here on.";
          case PATH_LIMIT ->
              slower(cause, joints) + "what drives can do along this path, or a blend.";
          case ACCELERATION ->
              "Speeding up, at " + acceleration(cause, joints) + slider(moment) + ".";
          case DECELERATION ->
              "Slowing down, for the end of the move or a corner, at "
                  + acceleration(cause, joints)
                  + slider(moment)
                  + ".";
        };
    return cause.certain() ? sentence : "Likely: " + sentence;
  }

  private String slower(Cause cause, boolean joints) {
    return "Slower than the command asks (" + speed(cause.asked(), joints) + "): ";
  }

  private String acceleration(Cause cause, boolean joints) {
    String rate = acceleration(cause.value(), joints);
    if (cause.asTheCommandSays()) {
      return rate + ", as the command says";
    }
    return Double.isNaN(cause.asked())
        ? rate
        : rate + "; the command says " + acceleration(cause.asked(), joints);
  }

  private String acceleration(double value, boolean joints) {
    return speed(value, joints) + "\u00b2";
  }

  private String speed(double value, boolean joints) {
    return joints ? figures.turn(value) + "/s" : figures.way(value) + "/s";
  }

  private static String slider(MotionExplanation moment) {
    double scaling = moment.now().arm().speedScaling();
    return scaling < 1
        ? String.format(Locale.ROOT, ", at %.0f %% by the speed slider", 100 * scaling)
        : "";
  }

  private String use(SpeedUse use) {
    String name = use.kind().words();
    String whose =
        use.kind() == SpeedUse.Kind.JOINT_SPEED
            ? " of " + JOINTS.get(use.joint()).toLowerCase(Locale.ROOT)
            : "";
    return name
        + whose
        + String.format(Locale.ROOT, " at %.0f %%", 100 * use.share())
        + " of "
        + limit(use);
  }

  private String limit(SpeedUse use) {
    return switch (use.kind()) {
      case JOINT_SPEED -> figures.turn(use.slowedAt()) + "/s";
      case TOOL_SPEED, ELBOW_SPEED -> figures.way(use.slowedAt()) + "/s";
      case MOMENTUM -> String.format(Locale.ROOT, "%.1f kg m/s", use.slowedAt());
      case STOPPING_TIME -> String.format(Locale.ROOT, "%.3f s", use.slowedAt());
      case STOPPING_DISTANCE -> figures.way(use.slowedAt());
    };
  }

  /** How near the limits that slow motions down are. */
  String limits(MotionExplanation moment) {
    List<String> texts =
        moment.uses().stream()
            .filter(each -> each.share() >= WORTH_TELLING)
            .limit(MAX_LIMITS)
            .map(this::use)
            .toList();
    return texts.isEmpty()
        ? ""
        : "Nearest to what slows motions down: " + String.join("; ", texts) + ".";
  }

  /** What was planned and what happened. */
  List<Row> rows(MotionExplanation moment) {
    ArmState arm = moment.now().arm();
    Pose planned = moment.now().geometry().targetTcpInBase();
    Pose actual = moment.now().geometry().actualTcpInBase();
    List<Row> rows = new ArrayList<>();
    DisplayUnit length = units.length();
    rows.add(row("Tool X", length, planned.x(), actual.x()));
    rows.add(row("Tool Y", length, planned.y(), actual.y()));
    rows.add(row("Tool Z", length, planned.z(), actual.z()));
    List<String> labels = units.labels();
    List<String> turns = units.readings(planned);
    List<String> turned = units.readings(actual);
    for (int i = 3; i < turns.size(); i++) {
      rows.add(new Row("Tool " + labels.get(i), turns.get(i), turned.get(i), ""));
    }
    rows.add(new Row("Following error", "", "", length.reading(moment.followingErrorM())));
    rows.add(
        rate("Tool speed", length, moment.plannedSpeedMPerS(), moment.actualSpeedMPerS(), "/s"));
    joints(rows, "", units.angle(), arm.targetPositionRad(), arm.actualPositionRad(), "");
    joints(rows, " speed", units.angle(), arm.targetSpeedRadPerS(), arm.actualSpeedRadPerS(), "/s");
    Joints wanted = moment.now().readings().targetTorqueNm();
    Joints given = moment.now().readings().torqueNm();
    for (int i = 0; i < Joints.COUNT; i++) {
      rows.add(
          new Row(
              JOINTS.get(i) + " torque",
              newtonMetres(wanted.get(i)),
              newtonMetres(given.get(i)),
              newtonMetres(given.get(i) - wanted.get(i))));
    }
    return rows;
  }

  private static String newtonMetres(double value) {
    return String.format(Locale.ROOT, "%.2f Nm", value);
  }

  private static void joints(
      List<Row> rows,
      String what,
      DisplayUnit unit,
      Joints planned,
      Joints actual,
      String perTime) {
    for (int i = 0; i < Joints.COUNT; i++) {
      rows.add(rate(JOINTS.get(i) + what, unit, planned.get(i), actual.get(i), perTime));
    }
  }

  private static Row row(String name, DisplayUnit unit, double planned, double actual) {
    return rate(name, unit, planned, actual, "");
  }

  private static Row rate(
      String name, DisplayUnit unit, double planned, double actual, String perTime) {
    return new Row(
        name,
        unit.reading(planned) + perTime,
        unit.reading(actual) + perTime,
        unit.reading(actual - planned) + perTime);
  }
}
