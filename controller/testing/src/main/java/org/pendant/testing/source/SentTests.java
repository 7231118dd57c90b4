package org.pendant.testing.source;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Expression.Call;
import org.pendant.language.syntax.Node;
import org.pendant.language.syntax.Statement;
import org.pendant.language.syntax.Statement.Assign;
import org.pendant.language.syntax.Statement.Definition;

/**
 * Sent tests: the tests of a file that start no program, each as a program that a robot elsewhere
 * runs by itself: what it calls of its file and of those that it imports, with {@link
 * SentAssertions}. Immutable.
 */
public final class SentTests {
  private final Source composed;
  private final List<Statement> statements;

  /**
   * The tests of a file.
   *
   * @param composed its text with those of the files that it imports
   * @param statements what people have written in them: values first, then functions
   */
  SentTests(Source composed, List<Statement> statements) {
    this.composed = composed;
    this.statements = List.copyOf(statements);
  }

  /** A stretch of the composed text that becomes something else. */
  private record Change(SourceRange range, String text) {}

  /** The text of the file with those of the files that it imports. */
  public Source source() {
    return composed;
  }

  /**
   * One test.
   *
   * @param calls what it may call
   * @param mark stands before what it tells by the log
   */
  public SentTest of(TestCase test, List<String> calls, String mark) {
    SentTest sent = new SentTest(test.place().line());
    sent.addOuter("def pendant_test():");
    SentAssertions.text(calls, mark).lines().forEach(sent::add);
    Set<String> called = new HashSet<>(calls);
    for (Statement each : statements) {
      if (!(each instanceof Definition definition) || called.contains(definition.name())) {
        add(each, sent);
      }
    }
    if (defined(TestFileReader.BEFORE)) {
      sent.add(TestFileReader.BEFORE + "()");
    }
    String row = ByteText.asBytes(test.id().row());
    String arguments = row.isEmpty() ? "" : row.substring(1, row.length() - 1);
    sent.add(test.id().function() + "(" + arguments + ")");
    if (defined(TestFileReader.AFTER)) {
      sent.add(TestFileReader.AFTER + "()");
    }
    sent.add(SentAssertions.PREFIX + "end()");
    sent.addOuter("end");
    return sent;
  }

  private boolean defined(String function) {
    return statements.stream()
        .anyMatch(each -> each instanceof Definition one && one.name().equals(function));
  }

  /** Adds a statement, whose assertions learn at which line they stand. */
  private void add(Statement statement, SentTest sent) {
    List<Change> changes = new ArrayList<>();
    SyntaxWalk.all(
        List.of(statement),
        each -> {
          if (each instanceof Call call && SentAssertions.names().contains(call.function())) {
            changes.add(change(call));
          }
        });
    halts(statement, changes);
    changes.sort(Comparator.comparingInt(each -> each.range().start()));
    // without a qualifier: what a file gives a name is known to all of its functions
    int at = (statement instanceof Assign assign ? assign.target() : statement).range().start();
    int line = composed.line(at);
    int shift = at - composed.lineStart(line);
    StringBuilder text = new StringBuilder();
    for (Change each : changes) {
      text.append(composed.text(), at, each.range().start()).append(each.text());
      at = each.range().end();
    }
    text.append(composed.text(), at, statement.range().end());
    for (String each : text.toString().split("\r?\n", -1)) {
      sent.add(each, line, shift, composed.lineText(line).startsWith(each, shift));
      line++;
      shift = 0;
    }
  }

  /** A test that halts has come to its end, which nobody else would know. */
  private static void halts(Node node, List<Change> changes) {
    if (node instanceof Statement.Halt halt) {
      changes.add(new Change(halt.range(), SentAssertions.PREFIX + "end()"));
    }
    node.children().forEach(each -> halts(each, changes));
  }

  /** From the name of the function to the parenthesis behind it. */
  private Change change(Call call) {
    int open = composed.text().indexOf('(', call.nameRange().end());
    int line = composed.line(call.range().start());
    return new Change(
        new SourceRange(call.nameRange().start(), open + 1),
        SentAssertions.PREFIX
            + call.function()
            + "("
            + line
            + (call.arguments().isEmpty() ? "" : ", "));
  }
}
