package org.pendant.project.program.script;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.TemplateStep;
import org.pendant.project.program.TemplateStep.PartKind;

/**
 * Seek writer: writes the search along a stack. The level is the distance from the start at which
 * the last item was found; the next search begins one item before the expected one.
 */
final class SeekWriter {
  /** Smallest deceleration when the search meets an item, which may be hard, m/s². */
  private static final double STOP_M_PER_S2 = 5;

  private final ScriptContext context;
  private final ScriptStepWriter steps;
  private final TemplateWriter templates;
  private final ScriptLines lines;
  private final Map<Long, String> levels = new HashMap<>();

  SeekWriter(ScriptContext context, ScriptStepWriter steps, TemplateWriter templates) {
    this.context = context;
    this.steps = steps;
    this.templates = templates;
    lines = context.lines();
  }

  /** The variable that keeps how far from the start the last item was found, m. */
  String level(ProgramNode seek) {
    return levels.computeIfAbsent(seek.key(), _ -> context.names().numbered("seek_level"));
  }

  void write(ProgramNode node, TemplateStep.Seek seek) {
    Optional<String> vector = vector(seek);
    if (vector.isEmpty() || !context.isTaught(seek.start())) {
      lines.begin(node, ScriptLines.NO_BREAK);
      lines.line("# this search needs a start and a direction");
      lines.end();
      return;
    }
    String counter = templates.counter(seek.name());
    lines.begin(node);
    if (TemplateWriter.has(node, PartKind.BEFORE_START)) {
      lines.open("if (" + counter + " == 0):");
      templates.part(node, PartKind.BEFORE_START);
      lines.close();
    }
    String way = context.names().numbered("seek_way");
    lines.line("global " + way + " = " + vector.get());
    search(node, seek, way, counter);
    lines.end();
  }

  private Optional<String> vector(TemplateStep.Seek seek) {
    return seek.direction().size() == 3
        ? steps
            .motion()
            .directions()
            .vector(
                seek.feature(),
                seek.direction().get(0),
                seek.direction().get(1),
                seek.direction().get(2))
        : Optional.empty();
  }

  private void search(ProgramNode node, TemplateStep.Seek seek, String way, String counter) {
    String start = steps.motion().pose(seek.start());
    String level = level(node);
    String place = context.names().numbered("seek_place");
    String met = context.names().numbered("seek_found");
    lines.line("global " + met + " = False");
    lines.line(line(start, seek));
    begin(seek, start, way, level);
    WatchedMove watched = new WatchedMove(context, node);
    watched.startMove(() -> lines.line(line(away(start, way, number(seek.limitM())), seek)));
    watched.watch();
    watched.when(ScriptText.condition(seek.found()));
    lines.line("global " + place + " = get_target_tcp_pose()");
    watched.stop("stopl(" + number(Math.max(STOP_M_PER_S2, seek.accelerationMPerS2())) + ")");
    lines.line(line(place, seek));
    lines.line(met + " = True");
    watched.leave();
    watched.when(watched.done());
    watched.leave();
    watched.close();
    lines.open("if (" + met + "):");
    lines.line("global " + level + " = point_dist(" + start + ", " + place + ")");
    lines.line("global " + counter + " = " + counter + " + 1");
    templates.sequence(node, place);
    if (!seek.destack()) {
      // the next item would lie above the start
      lines.open("if (" + level + " < " + number(seek.itemHeightM()) + "):");
      atEnd(node, counter, level);
      lines.close();
    }
    lines.between("else:");
    atEnd(node, counter, level);
    lines.close();
  }

  /** Moves to the level at which the search begins, unless that is the start. */
  private void begin(TemplateStep.Seek seek, String start, String way, String level) {
    String from = context.names().numbered("seek_from");
    double back = seek.destack() ? 0 : 2 * seek.itemHeightM();
    lines.line("global " + from + " = " + level + (back == 0 ? "" : " - " + number(back)));
    lines.open("if (" + from + " > 0):");
    lines.line(line(away(start, way, from), seek));
    lines.close();
  }

  private void atEnd(ProgramNode node, String counter, String level) {
    templates.part(node, PartKind.AFTER_END);
    lines.line("global " + counter + " = 0");
    lines.line("global " + level + " = 0.0");
  }

  private static String away(String start, String way, String distance) {
    return "pose_add(" + start + ", p" + DirectionWriter.scaled(way, distance) + ")";
  }

  private static String line(String place, TemplateStep.Seek seek) {
    return "movel("
        + place
        + ", a="
        + number(seek.accelerationMPerS2())
        + ", v="
        + number(seek.speedMPerS())
        + ")";
  }

  private static String number(double value) {
    return ScriptText.number(value);
  }
}
