package org.pendant.project.program.text;

import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.Section;
import org.pendant.project.program.Section.InitialValue;
import org.pendant.project.program.Step;
import org.pendant.project.program.WaypointPosition;

/** Program parser: reads a text once, line by line, and continues after what is wrong. */
final class TextReading {
  private static final int MAX_PROBLEMS = 100;
  private static final int MAX_NODES = 200_000;
  private static final String SUPPRESSED = "suppressed ";

  private final List<TextProblem> problems = new ArrayList<>();
  private final List<Line> lines = new ArrayList<>();
  private final Map<String, WaypointPosition> waypoints = new LinkedHashMap<>();
  private final List<ProgramNode> nodes = new ArrayList<>();
  private String installation = "";
  private boolean onlyMain;
  private int at;
  private int nodeCount;

  /**
   * A line that says something.
   *
   * @param number from 1
   * @param depth how far below the top, 0 for there
   * @param text without the blanks before it
   */
  private record Line(int number, int depth, String text) {
    int column() {
      return 1 + depth * ProgramText.INDENT.length();
    }

    boolean block() {
      return !text.isEmpty() && "|>-".indexOf(text.charAt(0)) >= 0;
    }
  }

  TextReading(String text, String heading) {
    split(text, heading);
    while (at < lines.size()) {
      Line line = lines.get(at);
      if (line.text().startsWith("position ") || line.text().startsWith("installation ")) {
        at++;
        header(line);
      } else {
        node(0).ifPresent(nodes::add);
      }
    }
    if (heading.equals(ProgramText.HEADING)) {
      requireMain();
    }
  }

  List<TextProblem> problems() {
    problems.sort((a, b) -> a.line() - b.line());
    return problems;
  }

  ProgramTree program() {
    List<ProgramNode> sections =
        nodes.stream().filter(each -> each.step() instanceof Section).toList();
    if (onlyMain) {
      List<ProgramNode> all = new ArrayList<>(sections);
      all.add(ProgramTree.node(new Section.MainProgram(true)));
      sections = all;
    }
    return new ProgramTree(installation, waypoints, List.of(), 1)
        .insert(ProgramTree.ROOT, 0, sections);
  }

  Clip clip() {
    return new Clip(nodes, waypoints);
  }

  private void requireMain() {
    List<ProgramNode> mains =
        nodes.stream().filter(each -> each.step() instanceof Section.MainProgram).toList();
    onlyMain = mains.isEmpty();
    if (mains.size() != 1) {
      complain(1, 1, ProgramLineTexts.text("severalMains", mains.size()));
    }
    Optional<ProgramNode> stray =
        nodes.stream().filter(each -> !(each.step() instanceof Section)).findFirst();
    stray.ifPresent(
        each ->
            complain(
                (int) each.key(),
                1,
                ProgramLineTexts.text("strayNode", Forms.word(each.step().getClass()))));
  }

  private void complain(int line, int column, String message) {
    if (problems.size() < MAX_PROBLEMS) {
      problems.add(new TextProblem(line, column, message));
    }
  }

  private void split(String text, String heading) {
    List<String> all = text.lines().toList();
    String first = all.isEmpty() ? "" : all.getFirst().stripTrailing();
    if (!first.equals(heading)) {
      complain(1, 1, ProgramLineTexts.text("firstLine", heading));
    }
    for (int i = 1; i < all.size(); i++) {
      split(i + 1, all.get(i));
    }
  }

  private void split(int number, String line) {
    String content = line.stripLeading();
    if (content.isEmpty()) {
      return;
    }
    String blanks = line.substring(0, line.length() - content.length());
    if (!blanks.chars().allMatch(c -> c == ' ') || blanks.length() % 2 != 0) {
      complain(number, 1, ProgramLineTexts.text("oddIndent"));
      return;
    }
    if (content.startsWith("#")) {
      complain(number, 1 + blanks.length(), ProgramLineTexts.text("remark"));
      return;
    }
    lines.add(new Line(number, blanks.length() / 2, content));
  }

  private void header(Line line) {
    try {
      if (line.depth() > 0) {
        throw new WrongText(1, ProgramLineTexts.text("notAtLeftEdge"));
      }
      LineText fields = LineText.parse(line.text(), line.column());
      if (fields.word().equals("installation")) {
        installation = new StepReader(fields, line.column()).read(File.class, Map.of()).file();
      } else {
        Position position = new StepReader(fields, line.column()).read(Position.class, Map.of());
        if (waypoints.putIfAbsent(position.name(), position.position()) != null) {
          throw new WrongText(1, ProgramLineTexts.text("positionTwice", position.name()));
        }
      }
    } catch (WrongText e) {
      complain(line.number(), e.column(), e.getMessage());
    }
  }

  /** The line of an installation. */
  record File(String file) {}

  /** The line of a place. */
  record Position(String name, Pose tcp, String feature, Joints jointsRad, Pose toolInFlange) {
    WaypointPosition position() {
      return new WaypointPosition(tcp, feature, jointsRad, toolInFlange);
    }
  }

  /** The node whose line comes next, with all that is below it. */
  private Optional<ProgramNode> node(int depth) {
    Line line = lines.get(at++);
    List<Line> blocks = new ArrayList<>();
    while (at < lines.size() && lines.get(at).depth() > depth && lines.get(at).block()) {
      blocks.add(lines.get(at++));
    }
    List<ProgramNode> children = new ArrayList<>();
    while (at < lines.size() && lines.get(at).depth() > depth && depth < ProgramTree.DEEPEST) {
      node(depth + 1).ifPresent(children::add);
    }
    if (depth == ProgramTree.DEEPEST) {
      skipBelow(depth, line);
    }
    try {
      if (line.depth() != depth) {
        throw new WrongText(1, ProgramLineTexts.text("tooFarRight", 2 * line.depth(), 2 * depth));
      }
      if (line.block()) {
        throw new WrongText(line.column(), ProgramLineTexts.text("blockWithoutNode"));
      }
      if (++nodeCount > MAX_NODES) {
        throw new WrongText(1, ProgramLineTexts.text("tooManyNodes", MAX_NODES));
      }
      boolean suppressed = line.text().startsWith(SUPPRESSED);
      int skip = suppressed ? SUPPRESSED.length() : 0;
      LineText fields = LineText.parse(line.text().substring(skip), line.column() + skip);
      // The key is the line until the nodes get theirs.
      return Optional.of(
          new ProgramNode(
              line.number(), step(fields, line.column() + skip, blocks), suppressed, children));
    } catch (WrongText e) {
      complain(line.number(), e.column(), e.getMessage());
      return Optional.empty();
    }
  }

  private void skipBelow(int depth, Line line) {
    if (at < lines.size() && lines.get(at).depth() > depth) {
      complain(line.number(), 1, ProgramLineTexts.text("tooDeep", ProgramTree.DEEPEST));
    }
    while (at < lines.size() && lines.get(at).depth() > depth) {
      at++;
    }
  }

  private Step step(LineText line, int column, List<Line> blockLines) throws WrongText {
    Class<? extends Record> type = Forms.step(line.word());
    if (type == null) {
      throw new WrongText(
          column,
          ProgramLineTexts.text("unknownNode", line.word(), String.join(", ", Forms.words())));
    }
    Map<String, List<?>> blocks = new HashMap<>();
    String marks = "";
    for (RecordComponent component : type.getRecordComponents()) {
      if (Forms.block(component)) {
        marks += Forms.mark(component);
        blocks.put(component.getName(), block(component, blockLines));
      }
    }
    for (Line each : blockLines) {
      char mark = each.text().charAt(0);
      if (marks.indexOf(mark) < 0) {
        complain(
            each.number(), each.column(), ProgramLineTexts.text("unknownBlock", line.word(), mark));
        break;
      }
    }
    return (Step) new StepReader(line, column).read(type, blocks);
  }

  /** What the lines of one component say. */
  private List<?> block(RecordComponent component, List<Line> lines) {
    List<Object> block = new ArrayList<>();
    for (Line each : lines) {
      if (each.text().charAt(0) == Forms.mark(component)) {
        try {
          block.add(Forms.rows(component) ? row(each) : blockText(each));
        } catch (WrongText e) {
          complain(each.number(), e.column(), e.getMessage());
        }
      }
    }
    return Collections.unmodifiableList(block);
  }

  private static InitialValue row(Line line) throws WrongText {
    String content = line.text().substring(1).stripLeading();
    int column = line.column() + line.text().length() - content.length();
    LineText fields = LineText.parse(content, column);
    return new StepReader(fields, column).read(InitialValue.class, Map.of());
  }

  private static String blockText(Line line) throws WrongText {
    String content = line.text().substring(1);
    if (content.startsWith("\"")) {
      LineText quoted = LineText.parse("text text=" + content, line.column() - 9);
      return StepReader.text("text", quoted.fields().get("text"));
    }
    return content.startsWith(" ") ? content.substring(1) : content;
  }
}
