package org.pendant.editors.dap.look;

import java.util.Optional;
import java.util.function.UnaryOperator;
import org.pendant.language.source.ByteText;
import org.pendant.script.debug.Variable;
import org.pendant.script.value.ValueKind;

/**
 * Shown: a variable or a part of one, as people read it.
 *
 * @param name of it among its neighbours
 * @param value its text, cut off where it is long
 * @param type of it; empty without a value
 * @param expression what yields it; empty where no expression does
 * @param branch its parts; empty for none
 * @param said whether its text is a message and no value
 */
public record Shown(
    String name,
    String value,
    String type,
    String expression,
    Optional<Branch> branch,
    boolean said) {
  /** One without parts, which no expression yields. */
  public static Shown leaf(String name, String value, String type) {
    return new Shown(name, value, type, "", Optional.empty(), false);
  }

  /** A message. */
  static Shown message(String name, String message) {
    return new Shown(name, message, "", "", Optional.empty(), true);
  }

  /** A variable with its parts. */
  static Shown of(Variable variable, Optional<Branch> branch) {
    return new Shown(
        ByteText.decoded(variable.name()),
        text(variable),
        variable.kind().map(ValueKind::text).orElse(""),
        ByteText.decoded(variable.expression()),
        branch,
        variable.kind().isEmpty());
  }

  private static String text(Variable variable) {
    if (variable.kind().isEmpty()) {
      return LookTexts.text("noValue");
    }
    String text = ByteText.decoded(variable.text());
    return variable.kind().get() == ValueKind.STRING ? '"' + text + '"' : text;
  }

  /** The same under another name. */
  public Shown named(String other) {
    return new Shown(other, value, type, expression, branch, said);
  }

  /**
   * Its text, which is translated if it is a message.
   *
   * @param translate says messages in the language of who looks
   */
  public String value(UnaryOperator<String> translate) {
    return said ? translate.apply(value) : value;
  }
}
