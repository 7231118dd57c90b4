package org.pendant.project.program.check;

import java.util.EnumMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.pendant.controller.installation.ConveyorSetup;
import org.pendant.project.program.MoveKind;
import org.pendant.project.program.Pattern;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.TemplateStep;
import org.pendant.project.program.TemplateStep.ForceKind;
import org.pendant.project.program.TemplateStep.PartKind;
import org.pendant.project.program.TemplateStep.PatternRole;
import org.pendant.project.program.TreeNames;

/** Checks templates. */
final class TemplateCheck {
  private static final int AXES = 6;
  private static final int FORCES = 3;
  private static final double MAX_N = 500;
  private static final double MAX_NM = 100;
  private static final double MAX_LIMIT = 10;
  private static final double MAX_M = 5;
  private static final double MAX_SCREW_M_PER_S = 1;
  private static final double MAX_S = 3600;
  private static final int FIRST_PIN = 8;
  private static final int LAST_PIN = 11;
  private static final int MAX_PLACES = 1_000_000;
  private static final int SQUARE_CORNERS = 4;
  private static final int BOX_CORNERS = 8;
  private static final List<String> AXIS_NAMES = List.of("x", "y", "z", "rx", "ry", "rz");

  private final CheckContext findings;
  private final SignalCheck signals;
  private final MotionCheck motion;
  private final Set<String> names = new HashSet<>();

  TemplateCheck(CheckContext findings, SignalCheck signals, MotionCheck motion) {
    this.findings = findings;
    this.signals = signals;
    this.motion = motion;
  }

  void check(ProgramNode node, TemplateStep step) {
    switch (step) {
      case TemplateStep.Palletizing palletizing -> palletizing(node, palletizing);
      case TemplateStep.PatternPoint point -> {
        findings.taught(node, "waypoint", point.waypoint());
        motion.speeds(
            node, "speed", point.speed(), "acceleration", point.acceleration(), point.kind());
        motion.blend(node, point.blendRadiusM());
      }
      case TemplateStep.Part _ -> {}
      case TemplateStep.Seek seek -> seek(node, seek);
      case TemplateStep.Force force -> force(node, force);
      case TemplateStep.Screwdriving screwdriving -> screwdriving(node, screwdriving);
      case TemplateStep.ConveyorTracking tracking -> conveyor(node, tracking.conveyor());
    }
  }

  private void name(ProgramNode node, String name) {
    findings.identifier(node, "name", "template", name);
    if (!name.isBlank() && !names.add(name)) {
      findings.problem(node, "name", "there is another template '" + name + "'");
    }
  }

  private void palletizing(ProgramNode node, TemplateStep.Palletizing palletizing) {
    name(node, palletizing.name());
    findings.feature(node, "feature", palletizing.feature());
    remembered(node, palletizing);
    pattern(node, palletizing.pattern());
    parts(node);
    if (points(node).getOrDefault(PatternRole.POINT, 0) == 0) {
      findings.problem(node, "", "the places are never gone to, expected a pattern point below it");
    }
  }

  /** Only variables of the installation outlive a program. */
  private void remembered(ProgramNode node, TemplateStep.Palletizing palletizing) {
    String counter = TreeNames.counter(palletizing.name());
    if (palletizing.remember()
        && findings.installation().variables().stream()
            .noneMatch(each -> each.name().equals(counter))) {
      findings.problem(
          node,
          "remember",
          "to keep the count, the installation must have a variable '" + counter + "'");
    }
  }

  private void pattern(ProgramNode node, Pattern pattern) {
    switch (pattern) {
      case Pattern.Line line -> count(node, "places of the line", line.count(), 2);
      case Pattern.Square square -> {
        corners(node, square.corners(), SQUARE_CORNERS);
        count(node, "columns", square.columns(), 1);
        count(node, "rows", square.rows(), 1);
      }
      case Pattern.Box box -> {
        corners(node, box.corners(), BOX_CORNERS);
        count(node, "columns", box.columns(), 1);
        count(node, "rows", box.rows(), 1);
        count(node, "layers", box.layers(), 1);
      }
      case Pattern.Places places -> {
        if (places.places().isEmpty()) {
          findings.problem(node, "pattern", "the pattern has no places");
        }
      }
    }
    for (String corner : TreeNames.corners(pattern)) {
      findings.taught(node, "pattern", corner);
    }
  }

  private void corners(ProgramNode node, List<String> corners, int wanted) {
    if (corners.size() != wanted) {
      findings.problem(
          node, "pattern", "the pattern has " + corners.size() + " corners, must have " + wanted);
    }
  }

  private void count(ProgramNode node, String what, int count, int least) {
    findings.range(node, "pattern", what, Shown.COUNT, count, least, MAX_PLACES);
  }

  /** How many places of each role there are, in the sequence of a template. */
  private Map<PatternRole, Integer> points(ProgramNode template) {
    Map<PatternRole, Integer> found = new EnumMap<>(PatternRole.class);
    count(MotionCheck.running(template), found);
    if (found.getOrDefault(PatternRole.POINT, 0) > 1) {
      findings.problem(template, "", "there are several pattern points, only one is the reference");
    }
    return found;
  }

  private void count(List<ProgramNode> nodes, Map<PatternRole, Integer> found) {
    for (ProgramNode each : nodes) {
      if (each.step() instanceof TemplateStep.PatternPoint point) {
        found.merge(point.role(), 1, Integer::sum);
      } else if (each.step() instanceof TemplateStep.Part(PartKind kind)) {
        if (kind == PartKind.SEQUENCE) {
          count(MotionCheck.running(each), found);
        } else {
          outside(MotionCheck.running(each));
        }
      }
    }
  }

  private void outside(List<ProgramNode> nodes) {
    for (ProgramNode each : nodes) {
      if (each.step() instanceof TemplateStep.PatternPoint) {
        findings.problem(each, "", "before the first and after the last item there is no place");
      }
    }
  }

  private void parts(ProgramNode template) {
    Set<PartKind> seen = new HashSet<>();
    for (ProgramNode each : MotionCheck.running(template)) {
      if (each.step() instanceof TemplateStep.Part(PartKind kind)
          && kind != PartKind.SEQUENCE
          && !seen.add(kind)) {
        findings.problem(each, "", "there is another part of this kind");
      }
    }
  }

  private void seek(ProgramNode node, TemplateStep.Seek seek) {
    name(node, seek.name());
    findings.taught(node, "start", seek.start());
    findings.feature(node, "feature", seek.feature());
    if (seek.direction().size() == FORCES) {
      motion.vector(
          node,
          "direction",
          seek.direction().get(0),
          seek.direction().get(1),
          seek.direction().get(2));
    } else {
      findings.problem(node, "direction", "the direction is missing, expected x, y and z");
    }
    findings.positive(node, "limitM", "farthest way", Shown.MILLIMETRE, seek.limitM(), MAX_M);
    findings.positive(
        node, "itemHeightM", "thickness of an item", Shown.MILLIMETRE, seek.itemHeightM(), MAX_M);
    findings.expression(node, "found", "condition for an item that is found", seek.found());
    motion.speeds(
        node,
        "speedMPerS",
        seek.speedMPerS(),
        "accelerationMPerS2",
        seek.accelerationMPerS2(),
        MoveKind.LINEAR);
    parts(node);
    Map<PatternRole, Integer> points = points(node);
    if (!points.isEmpty() && !points.containsKey(PatternRole.POINT)) {
      findings.problem(
          node, "", "approach and exit are relative to a pattern point, which is missing");
    }
  }

  private void force(ProgramNode node, TemplateStep.Force force) {
    findings.feature(node, "feature", force.feature());
    boolean complete =
        six(node, "compliant", force.compliant())
            && six(node, "wrench", force.wrench())
            && six(node, "limits", force.limits());
    if (!complete) {
      return;
    }
    for (int i = 0; i < AXES; i++) {
      boolean compliant = force.kind() == ForceKind.SIMPLE ? i == 2 : force.compliant().get(i);
      boolean line = i < FORCES;
      String axis = AXIS_NAMES.get(i);
      if (compliant) {
        double most = line ? MAX_N : MAX_NM;
        findings.range(
            node,
            "wrench",
            (line ? "force along " : "torque about ") + axis,
            line ? Shown.NEWTON : Shown.NEWTON_METRE,
            force.wrench().get(i),
            -most,
            most);
        findings.positive(
            node,
            "limits",
            "speed limit of " + axis,
            line ? Shown.MILLIMETRE_PER_S : Shown.DEGREE_PER_S,
            force.limits().get(i),
            MAX_LIMIT);
      } else {
        findings.range(
            node,
            "limits",
            "deviation limit of " + axis,
            line ? Shown.MILLIMETRE : Shown.DEGREE,
            force.limits().get(i),
            0,
            MAX_LIMIT);
      }
    }
    if (force.kind() != ForceKind.SIMPLE && !force.compliant().contains(true)) {
      findings.problem(node, "compliant", "no axis is compliant, nothing can press");
    }
  }

  private boolean six(ProgramNode node, String field, List<?> values) {
    if (values.size() == AXES) {
      return true;
    }
    findings.problem(node, field, "there are " + values.size() + " values, must be 6");
    return false;
  }

  private void screwdriving(ProgramNode node, TemplateStep.Screwdriving screwdriving) {
    findings.tool(node, "tool", screwdriving.tool());
    boolean byForce = screwdriving.byForce();
    findings.positive(
        node,
        "value",
        byForce ? "force" : "speed",
        byForce ? Shown.NEWTON : Shown.MILLIMETRE_PER_S,
        screwdriving.value(),
        byForce ? MAX_N : MAX_SCREW_M_PER_S);
    if (!screwdriving.start().isEmpty()) {
      signals.digitalOut(node, "start", screwdriving.start());
    }
    findings.range(node, "timeoutS", "time", Shown.SECOND, screwdriving.timeoutS(), 0, MAX_S);
    if (!screwdriving.until().isBlank() || MotionCheck.running(node).isEmpty()) {
      findings.expression(
          node, "until", "condition for a screw that is done", screwdriving.until());
    }
  }

  private void conveyor(ProgramNode node, int number) {
    Optional<ConveyorSetup> setup =
        findings.installation().conveyors().stream()
            .filter(each -> each.number() == number)
            .findFirst();
    if (setup.isEmpty()) {
      findings.problem(node, "conveyor", "the installation has no conveyor " + number);
      return;
    }
    findings.feature(node, "conveyor", setup.get().feature());
    List<Integer> inputs = setup.get().inputs();
    if (setup.get().decoder() != 0
        && (inputs.isEmpty()
            || inputs.stream().anyMatch(each -> each < FIRST_PIN || each > LAST_PIN))) {
      findings.problem(node, "conveyor", "the inputs of conveyor " + number + " must be 8 to 11");
    }
    if (setup.get().ticksPerUnit() == 0) {
      findings.problem(
          node, "conveyor", "conveyor " + number + " of the installation has no ticks per unit");
    }
  }
}
