package org.pendant.testing.remote;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.pendant.language.parse.ScriptParser;
import org.pendant.language.source.Source;
import org.pendant.language.syntax.Statement;
import org.pendant.language.syntax.Statement.Definition;
import org.pendant.language.syntax.Statement.DefinitionKind;

/**
 * Target script: the text of a program as ports take it, which is one {@code def} from the first
 * column on. In a file of definitions that is the last one, with the others inside it; any other
 * file becomes the body of one.
 */
public final class TargetScript implements SentText {
  private static final String INDENT = "  ";
  private static final int MAX_NAME = 31;

  private final String text;

  /** The line of the file that came first, before all lines above it; 0 where a line was added. */
  private final int firstLine;

  /** Lines of the text from which on no column is added. */
  private final int plainFrom;

  private TargetScript(String text, int firstLine, int plainFrom) {
    this.text = text;
    this.firstLine = firstLine;
    this.plainFrom = plainFrom;
  }

  /** The text of a program that compiles; empty where it runs beside another one, as a sec does. */
  public static Optional<TargetScript> of(Source program) {
    List<Statement> statements = ScriptParser.parseProgram(program).script().statements();
    boolean definitions = statements.stream().allMatch(Definition.class::isInstance);
    if (!definitions || statements.isEmpty()) {
      return Optional.of(ofStatements(program, ""));
    }
    Definition last = (Definition) statements.getLast();
    return switch (last.kind()) {
      case SECONDARY -> Optional.empty();
      case FUNCTION -> Optional.of(ofDefinitions(program, last));
      case THREAD -> Optional.of(ofStatements(program, calling(statements)));
    };
  }

  /** The call of the last function. */
  private static String calling(List<Statement> definitions) {
    String call = "";
    for (Statement each : definitions) {
      if (each instanceof Definition one && one.kind() == DefinitionKind.FUNCTION) {
        call = INDENT + one.name() + "()\n";
      }
    }
    return call;
  }

  private static TargetScript ofStatements(Source program, String after) {
    StringBuilder text = new StringBuilder("def " + name(program.name()) + "():\n");
    for (int i = 1; i <= program.lineCount(); i++) {
      append(text, INDENT, program.lineText(i));
    }
    return new TargetScript(text.append(after).append("end\n").toString(), 0, Integer.MAX_VALUE);
  }

  private static TargetScript ofDefinitions(Source program, Definition main) {
    int first = program.line(main.range().start());
    int end = program.line(Math.max(main.range().start(), main.range().end() - 1));
    StringBuilder text = new StringBuilder(program.lineText(first).strip()).append('\n');
    for (int i = 1; i < first; i++) {
      append(text, INDENT, program.lineText(i));
    }
    boolean flush = false;
    for (int i = first + 1; i < end; i++) {
      String line = program.lineText(i);
      flush |= !line.isEmpty() && !Character.isWhitespace(line.charAt(0));
    }
    for (int i = first + 1; i < end; i++) {
      append(text, flush ? INDENT : "", program.lineText(i));
    }
    return new TargetScript(
        text.append("end\n").toString(), first, flush ? Integer.MAX_VALUE : first + 1);
  }

  private static void append(StringBuilder text, String indent, String line) {
    text.append(line.isEmpty() ? "" : indent).append(line).append('\n');
  }

  /** A name that every controller takes. */
  private static String name(String file) {
    String last = file.substring(Math.max(file.lastIndexOf('/'), file.lastIndexOf('\\')) + 1);
    int dot = last.indexOf('.');
    String word =
        (dot > 0 ? last.substring(0, dot) : last)
            .toLowerCase(Locale.ROOT)
            .replaceAll("[^a-z0-9_]", "_");
    String name = "run_" + word;
    return name.substring(0, Math.min(name.length(), MAX_NAME));
  }

  @Override
  public String text() {
    return text;
  }

  @Override
  public int lineOf(int sent) {
    if (sent <= 1 && firstLine > 0) {
      return firstLine;
    }
    return Math.max(1, sent <= firstLine || firstLine == 0 ? sent - 1 : sent);
  }

  @Override
  public int columnOf(int sent, int column) {
    boolean indented = sent > 1 && sent < plainFrom;
    return Math.max(1, indented ? column - INDENT.length() : column);
  }
}
