package org.pendant.project.program.script;

import java.util.List;
import java.util.Optional;
import org.pendant.project.program.Pattern;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.TemplateStep;
import org.pendant.project.program.TemplateStep.PartKind;
import org.pendant.project.program.TreeNames;

/**
 * Pallet writer: writes palletizing: one place of a pattern each time, in the order of the pattern.
 */
final class PalletWriter {
  private static final int SQUARE_CORNERS = 4;
  private static final int BOX_CORNERS = 8;

  private final ScriptContext context;
  private final ScriptStepWriter steps;
  private final TemplateWriter templates;
  private final ScriptLines lines;

  PalletWriter(ScriptContext context, ScriptStepWriter steps, TemplateWriter templates) {
    this.context = context;
    this.steps = steps;
    this.templates = templates;
    lines = context.lines();
  }

  void write(ProgramNode node, TemplateStep.Palletizing palletizing) {
    Pattern pattern = palletizing.pattern();
    if (!complete(pattern)) {
      lines.begin(node, ScriptLines.NO_BREAK);
      lines.line("# this pattern is not complete");
      lines.end();
      return;
    }
    String counter = templates.counter(palletizing.name());
    String place = context.names().numbered("pallet_place");
    lines.begin(node);
    if (TemplateWriter.has(node, PartKind.BEFORE_START)) {
      lines.open("if (" + counter + " == 0):");
      templates.part(node, PartKind.BEFORE_START);
      lines.close();
    }
    place(pattern, counter, place);
    templates.sequence(node, place);
    lines.line("global " + counter + " = " + counter + " + 1");
    lines.open("if (" + counter + " >= " + count(pattern) + "):");
    templates.part(node, PartKind.AFTER_END);
    lines.line("global " + counter + " = 0");
    lines.close();
    lines.end();
  }

  private boolean complete(Pattern pattern) {
    List<String> corners = TreeNames.corners(pattern);
    boolean enough =
        switch (pattern) {
          case Pattern.Line _ -> true;
          case Pattern.Square _ -> corners.size() == SQUARE_CORNERS;
          case Pattern.Box _ -> corners.size() == BOX_CORNERS;
          case Pattern.Places _ -> !corners.isEmpty();
        };
    return enough && count(pattern) > 0 && corners.stream().allMatch(context::isTaught);
  }

  private static long count(Pattern pattern) {
    return switch (pattern) {
      case Pattern.Line line -> line.count();
      case Pattern.Square square -> (long) square.columns() * square.rows();
      case Pattern.Box box -> (long) box.columns() * box.rows() * box.layers();
      case Pattern.Places places -> places.places().size();
    };
  }

  /** Writes where the place with the number of the counter is. */
  private void place(Pattern pattern, String counter, String place) {
    switch (pattern) {
      case Pattern.Line line ->
          assign(
              place, between(pose(line.first()), pose(line.last()), part(counter, line.count())));
      case Pattern.Square square -> {
        Optional<String> column = column(counter, square.columns());
        Optional<String> row = part(whole(counter, square.columns()), square.rows());
        assign(place, inSquare(square.corners(), column, row));
      }
      case Pattern.Box box -> {
        int inLayer = box.columns() * box.rows();
        Optional<String> column = column(counter, box.columns());
        Optional<String> row =
            part("(" + whole(counter, box.columns()) + " % " + box.rows() + ")", box.rows());
        Optional<String> layer = part(whole(counter, inLayer), box.layers());
        assign(
            place,
            between(
                inSquare(box.corners().subList(0, SQUARE_CORNERS), column, row),
                inSquare(box.corners().subList(SQUARE_CORNERS, BOX_CORNERS), column, row),
                layer));
      }
      case Pattern.Places places -> oneOf(places.places(), counter, place);
    }
  }

  private void oneOf(List<String> places, String counter, String place) {
    assign(place, pose(places.getLast()));
    for (int i = 0; i < places.size() - 1; i++) {
      String head = "if (" + counter + " == " + i + "):";
      if (i == 0) {
        lines.open(head);
      } else {
        lines.between("el" + head);
      }
      lines.line(place + " = " + pose(places.get(i)));
    }
    if (places.size() > 1) {
      lines.close();
    }
  }

  private void assign(String variable, String value) {
    lines.line("global " + variable + " = " + value);
  }

  private String inSquare(List<String> corners, Optional<String> column, Optional<String> row) {
    return between(
        between(pose(corners.get(0)), pose(corners.get(1)), column),
        between(pose(corners.get(2)), pose(corners.get(3)), column),
        row);
  }

  private static String between(String from, String to, Optional<String> part) {
    return part.map(each -> "interpolate_pose(" + from + ", " + to + ", " + each + ")")
        .orElse(from);
  }

  private static Optional<String> column(String counter, int columns) {
    return part("(" + counter + " % " + columns + ")", columns);
  }

  /** How often {@code size} goes into the counter. */
  private static String whole(String counter, int size) {
    return size == 1 ? counter : "floor(" + counter + " / " + size + ".0)";
  }

  /** Which part of the way from the first to the last of so many a number is; none if it is one. */
  private static Optional<String> part(String number, int count) {
    return count == 1 ? Optional.empty() : Optional.of(number + " / " + (count - 1) + ".0");
  }

  private String pose(String waypoint) {
    return steps.motion().pose(waypoint);
  }
}
