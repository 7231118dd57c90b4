package org.pendant.project.program.script;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.TemplateStep;
import org.pendant.project.program.TemplateStep.PartKind;
import org.pendant.project.program.TemplateStep.PatternRole;
import org.pendant.project.program.TreeNames;

/**
 * Template writer: writes templates, each by the writer of its kind, and what is below those that
 * have places.
 */
final class TemplateWriter {
  private final ScriptContext context;
  private final ScriptStepWriter steps;
  private final ScriptLines lines;
  private final PalletWriter pallets;
  private final SeekWriter seeks;
  private final ProcessWriter processes;
  private final Deque<Places> open = new ArrayDeque<>();

  TemplateWriter(ScriptContext context, ScriptStepWriter steps) {
    this.context = context;
    this.steps = steps;
    lines = context.lines();
    pallets = new PalletWriter(context, steps, this);
    seeks = new SeekWriter(context, steps, this);
    processes = new ProcessWriter(context, steps);
  }

  /**
   * A template that is being written whose nodes may go to places.
   *
   * @param place variable with the pose of this time's place in the base frame
   * @param reference name of the waypoint that all places were taught relative to; empty if there
   *     is none
   */
  private record Places(String place, Optional<String> reference) {}

  /** Writes the variables that templates count in, with their first values. */
  void variables() {
    context.tree().sections().forEach(this::variables);
  }

  private void variables(ProgramNode node) {
    if (node.suppressed()) {
      return;
    }
    switch (node.step()) {
      case TemplateStep.Palletizing palletizing -> {
        // one that the installation keeps has been written with the installation's variables
        if (!(palletizing.remember() && isKept(TreeNames.counter(palletizing.name())))) {
          first(counter(palletizing.name()), "0");
        }
      }
      case TemplateStep.Seek seek -> {
        first(counter(seek.name()), "0");
        first(seeks.level(node), "0.0");
      }
      default -> {}
    }
    node.children().forEach(this::variables);
  }

  private boolean isKept(String variable) {
    return context.installation().variables().stream()
        .anyMatch(each -> each.name().equals(variable));
  }

  private void first(String variable, String value) {
    lines.line("global " + variable + " = " + value);
  }

  /** The variable in which a template of that name counts. */
  String counter(String name) {
    return context.names().variable(TreeNames.counter(name));
  }

  /** A template, or a part of one, with all below it. */
  void write(ProgramNode node, TemplateStep step) {
    switch (step) {
      case TemplateStep.Palletizing palletizing -> pallets.write(node, palletizing);
      case TemplateStep.Seek seek -> seeks.write(node, seek);
      case TemplateStep.PatternPoint point -> writePoint(node, point);
      case TemplateStep.Part _ -> writeBelow(node);
      case TemplateStep.Force force -> processes.write(node, force);
      case TemplateStep.Screwdriving screwdriving -> processes.write(node, screwdriving);
      case TemplateStep.ConveyorTracking tracking -> processes.write(node, tracking);
    }
  }

  /** A node that does nothing itself, with its children. */
  private void writeBelow(ProgramNode node) {
    lines.begin(node, ScriptLines.NO_BREAK);
    branch(node.children());
    lines.end();
  }

  /** Nodes that run only sometimes; which TCP is active is not sure in there, nor afterwards. */
  void branch(List<ProgramNode> nodes) {
    steps.writeAll(nodes);
  }

  /** What happens before the first or after the last item, if there is anything. */
  void part(ProgramNode template, PartKind kind) {
    parts(template, kind).forEach(this::writeBelow);
  }

  /** Whether anything happens before the first or after the last item. */
  static boolean has(ProgramNode template, PartKind kind) {
    return !parts(template, kind).isEmpty();
  }

  private static List<ProgramNode> parts(ProgramNode template, PartKind kind) {
    return template.children().stream()
        .filter(
            each ->
                !each.suppressed()
                    && each.step() instanceof TemplateStep.Part part
                    && part.kind() == kind)
        .toList();
  }

  /**
   * What happens each time.
   *
   * @param place variable with the pose of this time's place in the base frame
   */
  void sequence(ProgramNode template, String place) {
    List<ProgramNode> nodes = template.children().stream().filter(each -> !isAside(each)).toList();
    open.push(new Places(place, reference(template.children())));
    branch(nodes);
    open.pop();
  }

  private static boolean isAside(ProgramNode node) {
    return node.step() instanceof TemplateStep.Part part && part.kind() != PartKind.SEQUENCE;
  }

  private static Optional<String> reference(List<ProgramNode> nodes) {
    for (ProgramNode each : nodes) {
      Optional<String> found =
          switch (each.step()) {
            case TemplateStep.PatternPoint point when !each.suppressed() ->
                point.role() == PatternRole.POINT
                    ? Optional.of(point.waypoint())
                    : Optional.empty();
            // another template has its own
            case TemplateStep.Palletizing _, TemplateStep.Seek _ -> Optional.empty();
            default -> each.suppressed() ? Optional.empty() : reference(each.children());
          };
      if (found.isPresent()) {
        return found;
      }
    }
    return Optional.empty();
  }

  private void writePoint(ProgramNode node, TemplateStep.PatternPoint point) {
    Optional<String> place = place(point);
    if (place.isEmpty() || !context.isTaught(point.waypoint())) {
      lines.begin(node, ScriptLines.NO_BREAK);
      lines.line("# this place is not complete");
      lines.end();
      return;
    }
    lines.begin(node, ScriptLines.BREAK_AFTER);
    lines.line(
        MotionWriter.statement(
            point.kind(),
            new MotionWriter.Goal(
                place.get(), Optional.of(context.names().joints(point.waypoint()))),
            point.speed(),
            point.acceleration(),
            OptionalDouble.empty(),
            point.blendRadiusM()));
    lines.end();
  }

  /** Where a point is this time: as it was taught relative to the reference. */
  private Optional<String> place(TemplateStep.PatternPoint point) {
    if (open.isEmpty()) {
      return Optional.empty();
    }
    Places places = open.peek();
    return switch (point.role()) {
      case POINT -> Optional.of(places.place());
      case APPROACH, EXIT ->
          places
              .reference()
              .filter(context::isTaught)
              .map(
                  reference ->
                      "pose_trans("
                          + places.place()
                          + ", pose_trans(pose_inv("
                          + steps.motion().pose(reference)
                          + "), "
                          + steps.motion().pose(point.waypoint())
                          + "))");
    };
  }
}
