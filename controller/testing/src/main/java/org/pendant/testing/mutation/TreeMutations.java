package org.pendant.testing.mutation;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;

/**
 * Tree mutations: all mutations of one program tree, in the lines of its text: a node each, those
 * below it further in.
 */
final class TreeMutations {
  /** A field of a line: a word, a number, a text in quotes or a list. */
  private static final Pattern FIELD =
      Pattern.compile(
          "(?<= )(?<key>[a-z][a-z0-9-]*)=(?<value>\"(?:[^\"\\\\]|\\\\.)*\"|\\[[^\\]]*\\]|[^ ]+)");

  private static final Pattern LINE = Pattern.compile(" *(- )?(?<word>[a-z-]+)");
  private static final Pattern NUMBER = Pattern.compile("\\d+(\\.\\d+)?");
  private static final Pattern SIGNAL = Pattern.compile("\"(\\w+)\\[(\\d{1,2})\\]\"");

  private static final BigDecimal TWICE = BigDecimal.TWO;

  /** Nodes that do something by themselves, and so are missed where they are left out. */
  private static final Set<String> ACTIONS =
      Set.of("set", "wait", "call", "assignment", "home", "script-line", "script-file", "halt");

  private final Source source;
  private final Set<Integer> statements;
  private final List<Line> lines = new ArrayList<>();
  private final List<Mutation> found = new ArrayList<>();

  /** A line with a node, or a part of one. */
  private record Line(int number, int indent, String word, String text) {}

  private TreeMutations(Source source, Set<Integer> statements) {
    this.source = source;
    this.statements = statements;
  }

  /**
   * All mutations of a tree, in the order of its text.
   *
   * @param statements the lines whose nodes do something that tests may reach
   */
  static List<Mutation> in(Source source, Set<Integer> statements) {
    TreeMutations mutations = new TreeMutations(source, statements);
    mutations.read();
    for (int i = 0; i < mutations.lines.size(); i++) {
      mutations.look(i);
    }
    mutations.found.sort(
        Comparator.comparingInt((Mutation each) -> each.range().start())
            .thenComparingInt(each -> each.range().end())
            .thenComparing(Mutation::kind));
    return mutations.found;
  }

  private void read() {
    for (int number = 1; number <= source.lineCount(); number++) {
      String text = source.lineText(number);
      Matcher matcher = LINE.matcher(text);
      if (matcher.lookingAt()) {
        lines.add(new Line(number, matcher.start("word"), matcher.group("word"), text));
      }
    }
  }

  /** The line after the last one that is below a line. */
  private int end(int index) {
    int end = index + 1;
    while (end < lines.size() && lines.get(end).indent() > lines.get(index).indent()) {
      end++;
    }
    return end;
  }

  /** The line by which a node is reached: itself, or the first below it that does something. */
  private int reach(int index) {
    for (int i = index; i < end(index); i++) {
      if (statements.contains(lines.get(i).number())) {
        return lines.get(i).number();
      }
    }
    return lines.get(index).number();
  }

  private void look(int index) {
    Line line = lines.get(index);
    if (line.indent() == 0 || line.word().equals("initial")) {
      // settings of the whole program, named positions, headings of its parts, and what comes first
      return;
    }
    int reach = reach(index);
    dropped(index, reach);
    boolean level = false;
    Matcher field = FIELD.matcher(line.text());
    while (field.find()) {
      int start = source.lineStart(line.number()) + field.start("value");
      SourceRange range = new SourceRange(start, start + field.group("value").length());
      level |= field.group("key").equals("level");
      field(line, field.group("key"), field.group("value"), range, reach);
    }
    if (line.word().equals("set") && line.text().contains(" setting=digital ") && !level) {
      int end = source.lineStart(line.number()) + line.text().length();
      add(MutationKind.IO_SWAPPED, new SourceRange(end, end), " level=true", reach);
    }
  }

  private void add(MutationKind kind, SourceRange range, String replacement, int reach) {
    found.add(new Mutation(kind, range, replacement, reach));
  }

  private void field(Line line, String key, String value, SourceRange range, int reach) {
    switch (key) {
      case "condition" -> {
        String inside = value.substring(1, value.length() - 1);
        boolean negated = inside.startsWith("not ") && inside.matches("not [\\w\\[\\]()]+");
        String other = negated ? inside.substring(4) : "not (" + inside + ")";
        add(MutationKind.CONDITION, range, '"' + other + '"', reach);
      }
      case "level" ->
          add(MutationKind.IO_SWAPPED, range, value.equals("true") ? "false" : "true", reach);
      case "signal" -> {
        Matcher signal = SIGNAL.matcher(value);
        if (signal.matches()) {
          int other = Integer.parseInt(signal.group(2)) ^ 1;
          String name = '"' + signal.group(1) + '[' + other + "]\"";
          add(MutationKind.IO_SWAPPED, range, name, reach);
        }
      }
      case "count", "columns", "rows", "layers", "expression" -> {
        String plain = value.replace("\"", "");
        if (plain.matches("\\d{1,8}")) {
          String more = Integer.toString(Integer.parseInt(plain) + 1);
          add(MutationKind.CONSTANT, range, value.replace(plain, more), reach);
        }
      }
      default -> {
        if (isSpeed(line, key) && NUMBER.matcher(value).matches()) {
          BigDecimal number = new BigDecimal(value);
          if (number.signum() != 0) {
            String twice = number.multiply(TWICE).stripTrailingZeros().toPlainString();
            add(MutationKind.SPEED, range, twice, reach);
          }
        }
      }
    }
  }

  /** Whether a field says how fast something is, how long it takes, or how far it blends. */
  private static boolean isSpeed(Line line, String key) {
    return key.startsWith("speed")
        || key.startsWith("acceleration")
        || key.startsWith("blend-radius")
        || (key.equals("time-s") && !line.word().equals("loop"));
  }

  /** A node that is left out, with all that is below it; of a waypoint that is alone its move. */
  private void dropped(int index, int reach) {
    Line line = lines.get(index);
    switch (line.word()) {
      case "waypoint" -> {
        if (waypoints(parent(index)) > 1) {
          drop(MutationKind.MOVE_DROPPED, index, reach);
        }
      }
      case "move" -> {
        if (waypoints(index) == 1) {
          drop(MutationKind.MOVE_DROPPED, index, reach);
        }
      }
      default -> {
        boolean told = line.text().contains("code=\"textmsg(");
        if (ACTIONS.contains(line.word()) && !told) {
          boolean home = line.word().equals("home");
          drop(home ? MutationKind.MOVE_DROPPED : MutationKind.CALL_DROPPED, index, reach);
        }
      }
    }
  }

  private int parent(int index) {
    int parent = index;
    while (parent > 0 && lines.get(parent).indent() >= lines.get(index).indent()) {
      parent--;
    }
    return parent;
  }

  private long waypoints(int index) {
    return lines.subList(index + 1, end(index)).stream()
        .filter(each -> each.word().equals("waypoint"))
        .count();
  }

  private void drop(MutationKind kind, int index, int reach) {
    int last = lines.get(end(index) - 1).number();
    int start = source.lineStart(lines.get(index).number());
    int end = last < source.lineCount() ? source.lineStart(last + 1) : source.text().length();
    add(kind, new SourceRange(start, end), "", reach);
  }
}
