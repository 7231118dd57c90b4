package org.pendant.desktop.lines;

import static org.pendant.desktop.lines.LineTexts.text;

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
import org.pendant.text.Language;

/** Motion words: why the arm moved as it did, as people read it. */
final class MotionWords {
  private static final List<String> JOINTS =
      List.of(
          text("base"),
          text("shoulder"),
          text("elbow"),
          text("wrist1"),
          text("wrist2"),
          text("wrist3"));

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
    return line == 0
        ? text("noProgramRunsAt", time)
        : text("timeAndPlace", time, place.apply(line), moment.text());
  }

  /** What set the speed. */
  String cause(MotionExplanation moment) {
    Cause cause = moment.cause();
    boolean joints = moment.text().contains("movej");
    String sentence =
        switch (cause.kind()) {
          case REST -> text("theArmRests");
          case HAND -> text("aHandGuidesTheArm");
          case TORQUE -> text("torquesOfTheProgramDriveThe");
          case SAFETY_STOP -> text("aSafetyStopBringsTheArm");
          case PAUSE -> text("theProgramIsPausedTheArm");
          case START_RAMP -> text("theStartRampMovesComeUp");
          case SAFETY_LIMIT -> text("slowedDownByALimit", use(cause.use().orElseThrow()));
          case SCALING_RAMP -> text("theSpeedIsChangingToWhat");
          case SCALING ->
              String.format(Locale.ROOT, text("slowedDownToBySomethingThat"), 100 * cause.value());
          case COMMAND_SPEED ->
              text("fullSpeedOfTheCommand", slid(speed(cause.value(), joints), moment));
          case COMMAND_TIME -> text("steadyAtTheSpeed", slid(speed(cause.value(), joints), moment));
          case STREAMED -> text("theProgramSetsTheSpeedItself");
          case JOINT_LIMIT ->
              text("slowerForAJoint", speed(cause.asked(), joints), use(cause.use().orElseThrow()));
          case SHORT_WAY -> text("slowerForAShortWay", speed(cause.asked(), joints));
          case PATH_LIMIT -> text("slowerForThePath", speed(cause.asked(), joints));
          case ACCELERATION -> text("speedingUp", slid(acceleration(cause, joints), moment));
          case DECELERATION -> text("slowingDown", slid(acceleration(cause, joints), moment));
        };
    return cause.certain() ? sentence : text("likely", sentence);
  }

  private String acceleration(Cause cause, boolean joints) {
    String rate = acceleration(cause.value(), joints);
    if (cause.asTheCommandSays()) {
      return text("asTheCommandSays", rate);
    }
    return Double.isNaN(cause.asked())
        ? rate
        : text("theCommandSays", rate, acceleration(cause.asked(), joints));
  }

  private String acceleration(double value, boolean joints) {
    return speed(value, joints) + "\u00b2";
  }

  private String speed(double value, boolean joints) {
    return joints ? figures.turn(value) + "/s" : figures.way(value) + "/s";
  }

  /** What is said of a rate, and of the slider where that lowers it. */
  private static String slid(String rate, MotionExplanation moment) {
    double scaling = moment.now().arm().speedScaling();
    return scaling < 1
        ? text("bySpeedSlider", rate, String.format(Locale.ROOT, "%.0f", 100 * scaling))
        : rate;
  }

  private String use(SpeedUse use) {
    String percent = String.format(Locale.ROOT, "%.0f", 100 * use.share());
    return switch (use.kind()) {
      case JOINT_SPEED ->
          text(
              "jointSpeedUse",
              Language.ofProcess().withinSentence(JOINTS.get(use.joint())),
              percent,
              limit(use));
      case TOOL_SPEED -> text("toolSpeedUse", percent, limit(use));
      case ELBOW_SPEED -> text("elbowSpeedUse", percent, limit(use));
      case MOMENTUM -> text("momentumUse", percent, limit(use));
      case STOPPING_TIME -> text("stoppingTimeUse", percent, limit(use));
      case STOPPING_DISTANCE -> text("stoppingDistanceUse", percent, limit(use));
    };
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
    return texts.isEmpty() ? "" : text("nearestToWhatSlowsMotionsDown", String.join("; ", texts));
  }

  /** What was planned and what happened. */
  List<Row> rows(MotionExplanation moment) {
    ArmState arm = moment.now().arm();
    Pose planned = moment.now().geometry().targetTcpInBase();
    Pose actual = moment.now().geometry().actualTcpInBase();
    List<Row> rows = new ArrayList<>();
    DisplayUnit length = units.length();
    rows.add(row(text("toolX"), length, planned.x(), actual.x()));
    rows.add(row(text("toolY"), length, planned.y(), actual.y()));
    rows.add(row(text("toolZ"), length, planned.z(), actual.z()));
    List<String> labels = units.labels();
    List<String> turns = units.readings(planned);
    List<String> turned = units.readings(actual);
    for (int i = 3; i < turns.size(); i++) {
      rows.add(new Row(text("tool", labels.get(i)), turns.get(i), turned.get(i), ""));
    }
    rows.add(new Row(text("followingError"), "", "", length.reading(moment.followingErrorM())));
    rows.add(
        rate(
            text("toolSpeed"),
            length,
            moment.plannedSpeedMPerS(),
            moment.actualSpeedMPerS(),
            "/s"));
    joints(rows, "jointAngle", units.angle(), arm.targetPositionRad(), arm.actualPositionRad(), "");
    joints(
        rows,
        "jointSpeed",
        units.angle(),
        arm.targetSpeedRadPerS(),
        arm.actualSpeedRadPerS(),
        "/s");
    Joints wanted = moment.now().readings().targetTorqueNm();
    Joints given = moment.now().readings().torqueNm();
    for (int i = 0; i < Joints.COUNT; i++) {
      rows.add(
          new Row(
              text("jointTorque", JOINTS.get(i)),
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
      rows.add(rate(text(what, JOINTS.get(i)), unit, planned.get(i), actual.get(i), perTime));
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
