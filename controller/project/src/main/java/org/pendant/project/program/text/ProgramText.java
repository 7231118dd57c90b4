package org.pendant.project.program.text;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.WaypointPosition;

/**
 * Program trees as text: a heading, the places that were taught, then the nodes, one a line, below
 * each other by two blanks. The same tree always gives the same text.
 */
public final class ProgramText {
  /** Ending of the names of such files. */
  public static final String ENDING = ".pendant";

  /** With what every such text begins. */
  static final String HEADING = "pendant program 1";

  /** With what nodes in a clipboard begin. */
  static final String CLIP_HEADING = "pendant nodes 1";

  static final String INDENT = "  ";

  private ProgramText() {}

  /** The text of a program; lines end with a line feed. */
  public static String write(ProgramTree tree) {
    StringBuilder out = new StringBuilder(HEADING).append('\n');
    if (!tree.installation().isEmpty()) {
      out.append("installation file=").append(LineText.quoted(tree.installation())).append('\n');
    }
    positions(tree.waypoints(), out);
    tree.sections().forEach(each -> node(each, "", out));
    return out.toString();
  }

  /** Nodes, and the places that they need, as text for another program. */
  public static String writeClip(List<ProgramNode> nodes, Map<String, WaypointPosition> waypoints) {
    StringBuilder out = new StringBuilder(CLIP_HEADING).append('\n');
    positions(waypoints, out);
    nodes.forEach(each -> node(each, "", out));
    return out.toString();
  }

  private static void positions(Map<String, WaypointPosition> positions, StringBuilder out) {
    TextStepWriter writer = new TextStepWriter(out);
    positions.forEach(
        (name, position) -> {
          out.append("position");
          writer.field("name", name);
          writer.field("tcp", position.tcp());
          writer.field("feature", position.feature());
          writer.field("joints-rad", position.jointsRad());
          writer.field("tool-in-flange", position.toolInFlange());
          out.append('\n');
        });
  }

  private static void node(ProgramNode node, String indent, StringBuilder out) {
    TextStepWriter writer = new TextStepWriter(out);
    out.append(indent);
    if (node.suppressed()) {
      out.append("suppressed ");
    }
    writer.line(node.step());
    out.append('\n');
    String below = indent + INDENT;
    writer.blocks(node.step(), below);
    node.children().forEach(each -> node(each, below, out));
  }

  /** Whether a text says that it is a program tree. */
  public static boolean looksLike(String text) {
    return text.startsWith(HEADING);
  }

  /** Reads a program; keys count from 1 in the order of the lines. */
  public static ReadProgram read(String text) {
    TextReading reading = new TextReading(text, HEADING);
    return new ReadProgram(reading.program(), reading.problems());
  }

  /** Reads nodes from a clipboard; empty if the text is something else. */
  public static Optional<Clip> readClip(String text) {
    if (!text.startsWith(CLIP_HEADING)) {
      return Optional.empty();
    }
    TextReading reading = new TextReading(text, CLIP_HEADING);
    return reading.problems().isEmpty() ? Optional.of(reading.clip()) : Optional.empty();
  }
}
