package org.pendant.project.program.check;

import static org.pendant.project.program.check.ProgramCheckTexts.text;

import java.util.EnumMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.pendant.controller.installation.ConveyorSetup;
import org.pendant.project.program.NodeFields;
import org.pendant.project.program.Pattern;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.TemplateStep;
import org.pendant.project.program.TemplateStep.ForceKind;
import org.pendant.project.program.TemplateStep.PartKind;
import org.pendant.project.program.TemplateStep.PatternRole;
import org.pendant.project.program.TreeNames;

/** Template check: checks templates. */
final class TemplateCheck {
  private static final int AXES = 6;
  private static final int DIRECTION = 3;
  private static final int FIRST_PIN = 8;
  private static final int LAST_PIN = 11;
  private static final int SQUARE_CORNERS = 4;
  private static final int BOX_CORNERS = 8;

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
        motion.speeds(node, point.kind(), point.speed(), point.acceleration());
        findings.number(node, NodeFields.BLEND_RADIUS, point.blendRadiusM());
      }
      case TemplateStep.Part _ -> {}
      case TemplateStep.Seek seek -> seek(node, seek);
      case TemplateStep.Force force -> force(node, force);
      case TemplateStep.Screwdriving screwdriving -> screwdriving(node, screwdriving);
      case TemplateStep.ConveyorTracking tracking -> conveyor(node, tracking.conveyor());
    }
  }

  private void name(ProgramNode node, String name) {
    findings.identifier(node, "name", text("template"), name);
    if (!name.isBlank() && !names.add(name)) {
      findings.problem(node, "name", text("templateTwice", name));
    }
  }

  private void palletizing(ProgramNode node, TemplateStep.Palletizing palletizing) {
    name(node, palletizing.name());
    findings.feature(node, "feature", palletizing.feature());
    remembered(node, palletizing);
    pattern(node, palletizing.pattern());
    parts(node);
    if (points(node).getOrDefault(PatternRole.POINT, 0) == 0) {
      findings.problem(node, "", text("placesWithoutPoint"));
    }
  }

  /** Only variables of the installation outlive a program. */
  private void remembered(ProgramNode node, TemplateStep.Palletizing palletizing) {
    String counter = TreeNames.counter(palletizing.name());
    if (palletizing.remember()
        && findings.installation().variables().stream()
            .noneMatch(each -> each.name().equals(counter))) {
      findings.problem(node, "remember", text("countNotKept", counter));
    }
  }

  private void pattern(ProgramNode node, Pattern pattern) {
    switch (pattern) {
      case Pattern.Line line -> findings.number(node, NodeFields.LINE_PLACES, line.count());
      case Pattern.Square square -> {
        corners(node, square.corners(), SQUARE_CORNERS);
        findings.number(node, NodeFields.COLUMNS, square.columns());
        findings.number(node, NodeFields.ROWS, square.rows());
      }
      case Pattern.Box box -> {
        corners(node, box.corners(), BOX_CORNERS);
        findings.number(node, NodeFields.COLUMNS, box.columns());
        findings.number(node, NodeFields.ROWS, box.rows());
        findings.number(node, NodeFields.LAYERS, box.layers());
      }
      case Pattern.Places places -> {
        if (places.places().isEmpty()) {
          findings.problem(node, "pattern", text("patternEmpty"));
        }
      }
    }
    for (String corner : TreeNames.corners(pattern)) {
      findings.taught(node, "pattern", corner);
    }
  }

  private void corners(ProgramNode node, List<String> corners, int wanted) {
    if (corners.size() != wanted) {
      findings.problem(node, "pattern", text("patternCorners", corners.size(), wanted));
    }
  }

  /** How many places of each role there are, in the sequence of a template. */
  private Map<PatternRole, Integer> points(ProgramNode template) {
    Map<PatternRole, Integer> found = new EnumMap<>(PatternRole.class);
    count(MotionCheck.running(template), found);
    if (found.getOrDefault(PatternRole.POINT, 0) > 1) {
      findings.problem(template, "", text("severalPatternPoints"));
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
        findings.problem(each, "", text("placeOutside"));
      }
    }
  }

  private void parts(ProgramNode template) {
    Set<PartKind> seen = new HashSet<>();
    for (ProgramNode each : MotionCheck.running(template)) {
      if (each.step() instanceof TemplateStep.Part(PartKind kind)
          && kind != PartKind.SEQUENCE
          && !seen.add(kind)) {
        findings.problem(each, "", text("partTwice"));
      }
    }
  }

  private void seek(ProgramNode node, TemplateStep.Seek seek) {
    name(node, seek.name());
    findings.taught(node, "start", seek.start());
    findings.feature(node, "feature", seek.feature());
    if (seek.direction().size() == DIRECTION) {
      motion.vector(
          node,
          "direction",
          seek.direction().get(0),
          seek.direction().get(1),
          seek.direction().get(2));
    } else {
      findings.problem(node, "direction", text("directionMissing"));
    }
    findings.number(node, NodeFields.SEEK_LIMIT, seek.limitM());
    findings.number(node, NodeFields.ITEM_HEIGHT, seek.itemHeightM());
    findings.expression(node, "found", text("foundCondition"), seek.found());
    findings.number(node, NodeFields.SEEK_SPEED, seek.speedMPerS());
    findings.number(node, NodeFields.SEEK_ACCELERATION, seek.accelerationMPerS2());
    parts(node);
    Map<PatternRole, Integer> points = points(node);
    if (!points.isEmpty() && !points.containsKey(PatternRole.POINT)) {
      findings.problem(node, "", text("patternPointMissing"));
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
      if (compliant) {
        findings.number(node, NodeFields.wrench(i), force.wrench().get(i));
      }
      findings.number(node, NodeFields.forceLimit(i, compliant), force.limits().get(i));
    }
    if (force.kind() != ForceKind.SIMPLE && !force.compliant().contains(true)) {
      findings.problem(node, "compliant", text("noCompliantAxis"));
    }
  }

  private boolean six(ProgramNode node, String field, List<?> values) {
    if (values.size() == AXES) {
      return true;
    }
    findings.problem(node, field, text("sixValues", values.size()));
    return false;
  }

  private void screwdriving(ProgramNode node, TemplateStep.Screwdriving screwdriving) {
    findings.tool(node, "tool", screwdriving.tool());
    findings.number(node, NodeFields.screwValue(screwdriving.byForce()), screwdriving.value());
    if (!screwdriving.start().isEmpty()) {
      signals.digitalOut(node, "start", screwdriving.start());
    }
    findings.number(node, NodeFields.SCREW_TIMEOUT, screwdriving.timeoutS());
    if (!screwdriving.until().isBlank() || MotionCheck.running(node).isEmpty()) {
      findings.expression(node, "until", text("screwCondition"), screwdriving.until());
    }
  }

  private void conveyor(ProgramNode node, int number) {
    Optional<ConveyorSetup> setup =
        findings.installation().conveyors().stream()
            .filter(each -> each.number() == number)
            .findFirst();
    if (setup.isEmpty()) {
      findings.problem(node, "conveyor", text("noSuchConveyor", number));
      return;
    }
    findings.feature(node, "conveyor", setup.get().feature());
    List<Integer> inputs = setup.get().inputs();
    if (setup.get().decoder() != 0
        && (inputs.isEmpty()
            || inputs.stream().anyMatch(each -> each < FIRST_PIN || each > LAST_PIN))) {
      findings.problem(node, "conveyor", text("conveyorInputs", number));
    }
    if (setup.get().ticksPerUnit() == 0) {
      findings.problem(node, "conveyor", text("conveyorTicks", number));
    }
  }
}
