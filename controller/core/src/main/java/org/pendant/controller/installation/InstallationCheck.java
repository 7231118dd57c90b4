package org.pendant.controller.installation;

import static org.pendant.controller.installation.SetupTexts.text;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.InputAction;
import org.pendant.controller.io.RunStateAction;
import org.pendant.controller.io.ToolConnector;
import org.pendant.controller.safety.FittedSafety;
import org.pendant.controller.world.Vector3;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.pose.Pose;

/**
 * Installation check: finds what is wrong with an installation before a controller is set up with
 * it.
 */
public final class InstallationCheck {
  /** Farthest TCP and centre of gravity along each axis of the flange, m. */
  private static final double MAX_M = 4;

  /** Farthest point of a feature along each axis of the base, m. */
  private static final double MAX_POINT_M = 100;

  /** How often the rated payload may be declared; beyond, it likely means grams. */
  private static final double MAX_RATED_PAYLOADS = 4;

  private static final int MAX_NAME = 100;
  private static final int MOST = 1000;

  private final Installation installation;
  private final ArmDescription arm;
  private final ProblemList problems = new ProblemList();

  private InstallationCheck(Installation installation, ArmDescription arm) {
    this.installation = installation;
    this.arm = arm;
  }

  /**
   * What is wrong, in the order of an installation's components. A controller with that arm can be
   * set up with it if none of it {@link InstallationProblem#blocks}.
   */
  public static List<InstallationProblem> problems(Installation installation, ArmDescription arm) {
    InstallationCheck check = new InstallationCheck(installation, arm);
    check.run();
    return check.problems.all();
  }

  /** The first thing that keeps a controller with that arm from being set up. */
  public static Optional<InstallationProblem> refusal(
      Installation installation, ArmDescription arm) {
    return problems(installation, arm).stream().filter(InstallationProblem::blocks).findFirst();
  }

  private static String robotName(String id) {
    return ArmLibrary.ids().contains(id) ? ArmLibrary.load(id).displayName() : id;
  }

  private void run() {
    problems.require(
        installation.robot().isEmpty() || installation.robot().equals(arm.id()),
        "robot",
        () -> text("otherRobot", robotName(installation.robot()), arm.displayName()));
    tools();
    payloads();
    mounting();
    signals();
    wiring();
    features();
    problems.require(
        arm.withinLimits(installation.homeRad()),
        "homeRad",
        () -> text("homeRange", installation.homeRad(), arm.displayName()));
    variables();
    startUp();
    // what is beyond the arm is taken back to what it can do
    installation
        .safety()
        .ifPresent(
            safety ->
                FittedSafety.of(safety, arm)
                    .changes()
                    .forEach(each -> problems.remark("safety." + each.field(), each.message())));
    new FieldbusCheck(problems, installation).check();
    double hardness = installation.transitionHardness();
    problems.require(
        hardness == 0 || hardness == 1, "transitionHardness", () -> text("hardness", hardness));
    installation.controlHost().problem().ifPresent(why -> problems.add("controlHost", why));
  }

  /** A name of its own, that people can read. */
  private void name(String field, String name, Set<String> taken) {
    readable(field, name);
    problems.require(name.isBlank() || taken.add(name), field, () -> text("nameTaken", name));
  }

  private void readable(String field, String name) {
    problems.require(!name.isBlank(), field, () -> text("noName"));
    problems.require(
        name.length() <= MAX_NAME && name.chars().noneMatch(Character::isISOControl),
        field,
        () -> text("nameLine", MAX_NAME));
  }

  private void count(String field, int size) {
    problems.require(size <= MOST, field, () -> text("tooMany", size, MOST));
  }

  private void tools() {
    count("tools", installation.tools().size());
    Set<String> names = new HashSet<>();
    for (int i = 0; i < installation.tools().size(); i++) {
      NamedTool tool = installation.tools().get(i);
      String field = "tools[" + i + "].";
      name(field + "name", tool.name(), names);
      pose(field + "inFlange", tool.inFlange(), MAX_M);
    }
    problems.require(
        installation.activeTool().isEmpty() || names.contains(installation.activeTool()),
        "activeTool",
        () -> text("unknownTcp", installation.activeTool()));
  }

  private void payloads() {
    count("payloads", installation.payloads().size());
    Set<String> names = new HashSet<>();
    double mostKg = MAX_RATED_PAYLOADS * arm.payloadKg();
    for (int i = 0; i < installation.payloads().size(); i++) {
      NamedPayload payload = installation.payloads().get(i);
      String field = "payloads[" + i + "].";
      name(field + "name", payload.name(), names);
      double massKg = payload.massKg();
      problems.require(
          massKg >= 0 && massKg <= mostKg,
          field + "massKg",
          () -> text("massRange", massKg, mostKg, arm.displayName()));
      Vector3 cog = payload.cogM();
      problems.require(
          near(cog.x(), cog.y(), cog.z(), MAX_M),
          field + "cogM",
          () -> text("cogRange", MAX_M, MAX_M));
      payload
          .inertia()
          .problem()
          .ifPresent(why -> problems.add(field + "inertia", text("inertiaRefused", why)));
    }
    problems.require(
        installation.activePayload().isEmpty() || names.contains(installation.activePayload()),
        "activePayload",
        () -> text("unknownPayload", installation.activePayload()));
  }

  private void pose(String field, Pose pose, double farthestM) {
    problems.require(
        near(pose.x(), pose.y(), pose.z(), farthestM),
        field,
        () -> text("positionRange", farthestM, farthestM));
    problems.require(
        near(pose.rx(), pose.ry(), pose.rz(), 1e6), field, () -> text("rotationFinite"));
  }

  private static boolean near(double x, double y, double z, double farthest) {
    return Math.abs(x) <= farthest && Math.abs(y) <= farthest && Math.abs(z) <= farthest;
  }

  private void mounting() {
    BaseMounting mounting = installation.mounting();
    angle("mounting.tiltRad", mounting.tiltRad());
    angle("mounting.rotationRad", mounting.rotationRad());
  }

  private void angle(String field, double rad) {
    problems.require(Math.abs(rad) <= 2 * Math.PI, field, () -> text("angleRange", rad));
  }

  private void signals() {
    Set<String> ids = new HashSet<>();
    Set<String> names = new HashSet<>();
    for (int i = 0; i < installation.signals().size(); i++) {
      SignalUse use = installation.signals().get(i);
      String field = "signals[" + i + "].";
      Optional<SignalId> id = SignalId.of(use.signal());
      problems.require(id.isPresent(), field + "signal", () -> text("unknownSignal", use.signal()));
      problems.require(
          ids.add(use.signal()), field + "signal", () -> text("signalTwice", use.signal()));
      if (!use.name().isEmpty()) {
        readable(field + "name", use.name());
        if (!names.add(use.name())) {
          // robots allow it; programs then mean the first one
          problems.remark(field + "name", text("nameTaken", use.name()));
        }
      }
      problems.require(
          id.isEmpty() || use.input() == InputAction.DEFAULT || id.get().takesInputAction(),
          field + "input",
          () -> text("noDigitalInput", use.signal()));
      problems.require(
          id.isEmpty() || use.output() == RunStateAction.PRESERVE || id.get().takesOutputAction(),
          field + "output",
          () -> text("noFollowingOutput", use.signal()));
    }
  }

  private void wiring() {
    Wiring wiring = installation.wiring();
    two("wiring.analogIn", wiring.analogIn());
    two("wiring.analogOut", wiring.analogOut());
    two("wiring.toolAnalogIn", wiring.toolAnalogIn());
    two("wiring.toolPins", wiring.toolPins());
    problems.require(
        ToolConnector.isVoltage(wiring.toolVoltage()),
        "wiring.toolVoltage",
        () -> text("voltageRange", wiring.toolVoltage()));
  }

  private void two(String field, List<?> values) {
    problems.require(
        values.size() == AnalogBank.SIZE,
        field,
        () -> text("countOf", values.size(), AnalogBank.SIZE));
  }

  private void features() {
    count("features", installation.features().size());
    Set<String> names = new HashSet<>();
    for (int i = 0; i < installation.features().size(); i++) {
      Feature feature = installation.features().get(i);
      String field = "features[" + i + "].";
      scriptName(field + "name", feature.name(), names);
      for (int j = 0; j < feature.points().size(); j++) {
        pose(field + "points[" + j + "]", feature.points().get(j), MAX_POINT_M);
      }
      int wanted = feature.kind().points();
      int given = feature.points().size();
      if (given != wanted) {
        problems.remark(field + "points", text("pointsMissing", feature.name(), given, wanted));
      } else if (FeaturePoses.pose(feature).isEmpty()) {
        problems.remark(
            field + "points",
            text(
                feature.kind() == FeatureKind.PLANE ? "pointsOnOneLine" : "pointsInOnePlace",
                feature.name()));
      }
    }
  }

  /** A name by which programs can call a variable. */
  private void scriptName(String field, String name, Set<String> taken) {
    problems.require(ScriptWords.isName(name), field, () -> text("noScriptName", name));
    problems.require(name.isEmpty() || taken.add(name), field, () -> text("nameTaken", name));
    problems.require(name.length() <= MAX_NAME, field, () -> text("nameLength", MAX_NAME));
  }

  private void variables() {
    count("variables", installation.variables().size());
    Set<String> names = new HashSet<>();
    installation.features().stream().map(Feature::name).forEach(names::add);
    for (int i = 0; i < installation.variables().size(); i++) {
      InstallationVariable variable = installation.variables().get(i);
      String field = "variables[" + i + "].";
      scriptName(field + "name", variable.name(), names);
      ScriptWords.valueProblem(variable.value())
          .ifPresent(why -> problems.add(field + "value", why));
    }
  }

  private void startUp() {
    StartUp startUp = installation.startUp();
    startInput("startUp.startInput", startUp.startInput());
    startInput("startUp.powerInput", startUp.powerInput());
    problems.require(
        startUp.program().isEmpty() || startUp.program().matches("(?s).+\\.(script|pendant|urp)"),
        "startUp.program",
        () -> text("startProgram", startUp.program()));
  }

  private void startInput(String field, String input) {
    problems.require(
        input.isEmpty() || SignalId.digitalInput(input).isPresent(),
        field,
        () -> text("startInput", input));
  }
}
