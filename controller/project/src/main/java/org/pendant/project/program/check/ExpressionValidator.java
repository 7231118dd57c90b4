package org.pendant.project.program.check;

import static org.pendant.project.program.check.ProgramCheckTexts.text;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.pendant.language.parse.ParseResult;
import org.pendant.language.parse.ScriptParser;
import org.pendant.language.service.GuestExpression;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.language.syntax.Statement;
import org.pendant.project.program.check.CheckContext.TypedText;

/**
 * Expression validator: finds expressions that cannot be read. All are read in one go, as
 * conditions one below another; only when something is wrong are they taken apart, half by half, to
 * find out what.
 */
final class ExpressionValidator {
  private static final String BEFORE = "if (";
  private static final String BEHIND = "):\nend\n";
  private static final Pattern LINE_END = Pattern.compile("[\\r\\n]");
  private static final Source NOTHING = Source.of("nothing", "");

  /** The code of what {@link GuestExpression} refuses before it reads. */
  private static final String NO_EXPRESSION = "not-an-expression";

  private final CheckContext findings;
  private final Catalogue catalogue;

  ExpressionValidator(CheckContext findings, Catalogue catalogue) {
    this.findings = findings;
    this.catalogue = catalogue;
  }

  /** Reports what cannot be read. */
  void check() {
    check(findings.expressions());
  }

  private void check(List<TypedText> texts) {
    if (texts.isEmpty() || sound(texts)) {
      return;
    }
    if (texts.size() == 1) {
      TypedText wrong = texts.getFirst();
      findings.problem(wrong.key(), wrong.field(), explained(wrong.text()));
      return;
    }
    int half = texts.size() / 2;
    check(texts.subList(0, half));
    check(texts.subList(half, texts.size()));
  }

  private static boolean sound(List<TypedText> texts) {
    StringBuilder script = new StringBuilder();
    for (TypedText each : texts) {
      if (!closed(each.text())) {
        return false;
      }
      script.append(BEFORE).append(ByteText.asBytes(each.text())).append(BEHIND);
    }
    ParseResult parsed = parse(script.toString());
    return parsed.ok() && conditionsOnly(parsed.script().statements(), texts);
  }

  private static ParseResult parse(String bytes) {
    return ScriptParser.parseProgram(
        Source.of("expressions", bytes.getBytes(StandardCharsets.ISO_8859_1)));
  }

  /** Whether every text has become one condition and nothing else. */
  private static boolean conditionsOnly(List<Statement> statements, List<TypedText> texts) {
    return statements.size() == texts.size()
        && statements.stream()
            .allMatch(
                each ->
                    each instanceof Statement.If condition
                        && condition.branches().size() == 1
                        && condition.branches().getFirst().body().isEmpty()
                        && condition.otherwise().isEmpty());
  }

  /** Whether a text stays on its line and never closes a bracket that it has not opened. */
  private static boolean closed(String text) {
    if (LINE_END.matcher(text).find()) {
      return false;
    }
    int depth = 0;
    boolean quoted = false;
    for (int i = 0; i < text.length() && depth >= 0; i++) {
      char each = text.charAt(i);
      if (each == '"') {
        quoted = !quoted;
      } else if (!quoted && (each == '(' || each == '[')) {
        depth++;
      } else if (!quoted && (each == ')' || each == ']')) {
        depth--;
      }
    }
    return depth == 0 && !quoted;
  }

  private String explained(String text) {
    if (LINE_END.matcher(text).find()) {
      return text("severalLines");
    }
    String bytes = ByteText.asBytes(text);
    Optional<Diagnostic> refusal =
        GuestExpression.of(NOTHING, catalogue, 1, bytes)
            .problem()
            .filter(found -> found.code().equals(NO_EXPRESSION));
    int before = refusal.isPresent() ? 0 : BEFORE.length();
    Optional<Diagnostic> found =
        refusal.or(
            () ->
                parse(BEFORE + bytes + BEHIND).diagnostics().stream()
                    .filter(Diagnostic::isError)
                    .findFirst());
    return found
        .map(wrong -> located(text, bytes, wrong.range().start() - before, wrong.message()))
        .orElse(text("severalExpressions"));
  }

  /** A message with the column that it is about, counted from 1 in characters. */
  static String located(String text, String bytes, int offset, String message) {
    int within = Math.clamp(offset, 0, bytes.length());
    int column = ByteText.decoded(bytes.substring(0, within)).length() + 1;
    String about =
        ByteText.decoded(offset < bytes.length() ? message : GuestExpression.atEnd(message));
    return text.length() > 1 ? text("atColumn", column, about) : about;
  }
}
