package org.pendant.project.program.script;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.regex.Pattern;
import org.pendant.project.program.ControlScript;
import org.pendant.project.program.ProgramNode;
import org.pendant.project.program.ProgramTree;
import org.pendant.project.program.StepNames;

/**
 * Script lines: a script while it is written, line by line, and which lines belong to which node. A
 * node may be written several times; it has its first number then.
 */
final class ScriptLines {
  /** The label of a node at which a program cannot be paused. */
  static final String NO_BREAK = "noBreak";

  /** The label of a node at which a program is paused when it is done with it. */
  static final String BREAK_AFTER = "breakAfter";

  /** A loop without end; it tests nothing, so no breakpoint stops there. */
  static final String ENDLESS = "while (True):";

  private static final String INDENT = "  ";
  private static final Pattern REMARK = Pattern.compile("\\s*(#|$)");

  /** Statements after which nothing in their block is reached. */
  private static final Pattern LEAVING = Pattern.compile("\\s*(halt|break|continue|return)\\b");

  private final StringBuilder text = new StringBuilder();
  private final Map<Long, Integer> numbers = new HashMap<>();
  private final List<GeneratedScript.NodeLines> places = new ArrayList<>();
  private final List<GeneratedScript.Received> received = new ArrayList<>();
  private final Deque<Open> open = new ArrayDeque<>();
  private int lines;
  private int depth;

  /** The depth of the block that the last statement has left for good; -1 for none. */
  private int leftDepth = -1;

  /** How many of the open nodes a line may be the first of; those opened earlier wait. */
  private int asideDepth;

  /** A node that is being written. */
  private static final class Open {
    private final ProgramNode node;
    private final int labelLine;
    private int first;

    /** The first line that is no statement; 0 for none. */
    private int remark;

    Open(ProgramNode node, int labelLine) {
      this.node = node;
      this.labelLine = labelLine;
    }
  }

  ScriptLines(ProgramTree tree) {
    List<ProgramNode> nodes = tree.nodes();
    for (int i = 0; i < nodes.size(); i++) {
      numbers.putIfAbsent(nodes.get(i).key(), i + 1);
    }
  }

  /** One line at the present indentation. */
  void line(String code) {
    text.append(code.isEmpty() ? "" : INDENT.repeat(depth)).append(code).append('\n');
    lines++;
    boolean remark = REMARK.matcher(code).lookingAt();
    if (!remark) {
      leftDepth = LEAVING.matcher(code).lookingAt() ? depth : -1;
    }
    begun(!remark && !code.equals(ENDLESS));
  }

  /** The newest line is the first one of all open nodes that have none. */
  private void begun(boolean statement) {
    int waiting = open.size() - asideDepth;
    for (Open each : open) {
      if (waiting-- <= 0 || each.first > 0) {
        break;
      }
      if (statement) {
        each.first = lines;
      } else if (each.remark == 0) {
        each.remark = lines;
      }
    }
  }

  /** A line as people have typed it. */
  void code(String typed) {
    line(ScriptText.oneLine(typed).stripTrailing());
  }

  /** Lines that were received, which are told apart in messages. */
  void received(List<ControlScript.Line> text) {
    int first = lines + 1;
    for (int i = 0; i < text.size(); i++) {
      code(text.get(i).text());
      boolean last = i == text.size() - 1;
      if (last || text.get(i + 1).number() != text.get(i).number() + 1) {
        int from = text.get(i).number() - (lines - first);
        received.add(new GeneratedScript.Received(first, lines, from));
        first = lines + 1;
      }
    }
  }

  /** A line that belongs after what people put into a block, unless nothing leads there. */
  void last(String code) {
    if (leftDepth != depth) {
      line(code);
    }
  }

  /** A line that opens a block. */
  void open(String head) {
    line(head);
    depth++;
  }

  /** A line between two blocks, as {@code else:}. */
  void between(String head) {
    depth--;
    open(head);
  }

  /** Ends a block. */
  void close() {
    depth--;
    text.append(INDENT.repeat(depth)).append("end\n");
    lines++;
    leftDepth = -1;
  }

  /**
   * Begins a node with its label. The line after that is where a breakpoint on the node stops,
   * unless it is written {@link #aside}.
   *
   * @param marks {@link #NO_BREAK}, {@link #BREAK_AFTER} or none
   */
  void begin(ProgramNode node, String... marks) {
    StringBuilder label = new StringBuilder(INDENT.repeat(depth));
    label.append("$ ").append(number(node)).append(' ');
    label.append(ScriptText.string(StepNames.label(node)));
    for (String mark : marks) {
      label.append(" \"").append(mark).append('"');
    }
    text.append(label).append('\n');
    lines++;
    open.push(new Open(node, lines));
  }

  /** Ends the node that was begun last. */
  void end() {
    Open done = open.pop();
    int number = number(done.node);
    int other = done.remark > 0 ? done.remark : done.labelLine;
    int first = done.first > 0 ? done.first : other;
    places.add(new GeneratedScript.NodeLines(done.node.key(), number, first, lines));
  }

  /**
   * Writes something, usually a function or thread, that the nodes which are open now do not begin
   * with.
   */
  void aside(Runnable writing) {
    int before = asideDepth;
    asideDepth = open.size();
    writing.run();
    asideDepth = before;
  }

  /** The number of a node in the tree, from 1, as in its label. */
  int number(ProgramNode node) {
    return Objects.requireNonNull(numbers.get(node.key()), "a node of another tree");
  }

  /** The script so far. */
  GeneratedScript script(GeneratedNames names) {
    places.sort(
        Comparator.comparingInt(GeneratedScript.NodeLines::number)
            .thenComparingInt(GeneratedScript.NodeLines::first));
    return new GeneratedScript(text.toString(), places, received, names);
  }
}
