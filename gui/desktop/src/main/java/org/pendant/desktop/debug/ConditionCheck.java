package org.pendant.desktop.debug;

import java.util.List;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.pendant.kit.background.WorkQueue;
import org.pendant.kit.text.Messages;
import org.pendant.language.service.CharacterOffsets;
import org.pendant.language.service.Completion;
import org.pendant.language.service.GuestExpression;
import org.pendant.language.signature.Catalogue;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Source;
import org.pendant.script.debug.LogMessage;

/**
 * Condition check: reads conditions and messages of breakpoints as they are typed, at the line of
 * the program where they are to be computed. One thread uses it, the dispatch thread; the reading
 * happens elsewhere.
 */
public final class ConditionCheck {
  /** How long typing must rest before a condition is read. */
  private static final int PAUSE_MS = 150;

  /** Texts up to this length are read while the user waits: a few dozen milliseconds. */
  private static final int SHORT = 300_000;

  private final WorkQueue background;
  private final Executor dispatch;
  private final Catalogue catalogue;
  private final Supplier<Source> program;
  private final boolean messages;
  private Result newest = new Result(0, "", "");
  private int version;

  /** What was found out about a condition. */
  private record Result(int line, String text, String refusal) {
    boolean isOf(int otherLine, String other) {
      return line == otherLine && text.equals(other);
    }
  }

  /**
   * Nothing is read yet.
   *
   * @param program the text with the breakpoints, as it is now
   */
  public ConditionCheck(
      WorkQueue background, Executor dispatch, Catalogue catalogue, Supplier<Source> program) {
    this(background, dispatch, catalogue, program, false);
  }

  private ConditionCheck(
      WorkQueue background,
      Executor dispatch,
      Catalogue catalogue,
      Supplier<Source> program,
      boolean messages) {
    this.messages = messages;
    this.background = background;
    this.dispatch = dispatch;
    this.catalogue = catalogue;
    this.program = program;
  }

  /** One for messages, which have expressions in braces. */
  ConditionCheck forMessages() {
    return new ConditionCheck(background, dispatch, catalogue, program, true);
  }

  /** Tells why {@code text} cannot be a condition at {@code line}; empty if it can. */
  public void check(int line, String text, Consumer<String> refusal) {
    int asked = ++version;
    Source source = program.get();
    background.run(
        PAUSE_MS,
        () -> {
          Result found = new Result(line, text, refusal(source, line, text));
          dispatch.execute(
              () -> {
                if (asked == version) {
                  newest = found;
                  refusal.accept(found.refusal());
                }
              });
        });
  }

  /** The same at once; a very long program is not read for it. */
  public String now(int line, String text) {
    if (!newest.isOf(line, text)) {
      Source source = program.get();
      if (source.text().length() > SHORT) {
        return "";
      }
      newest = new Result(line, text, refusal(source, line, text));
    }
    return newest.refusal();
  }

  private String refusal(Source source, int line, String text) {
    List<String> expressions =
        messages
            ? LogMessage.of(text).expressions().stream().map(LogMessage.Part::text).toList()
            : text.isBlank() ? List.of() : List.of(text);
    return expressions.stream()
        .flatMap(
            each ->
                GuestExpression.of(source, catalogue, line, ByteText.asBytes(each))
                    .problem()
                    .stream())
        .map(found -> Messages.shown(ByteText.decoded(found.message())))
        .findFirst()
        .orElse("");
  }

  /** Tells what may be typed behind the first {@code caret} characters of a condition. */
  public void complete(int line, String text, int caret, Consumer<List<Completion>> offered) {
    Source source = program.get();
    String before = text.substring(0, caret);
    int begin = messages ? before.lastIndexOf('{') + 1 : 0;
    if (messages && (begin == 0 || before.indexOf('}', begin) >= 0)) {
      offered.accept(List.of());
      return;
    }
    String expression = messages ? before.substring(begin) : text;
    int offset = CharacterOffsets.of(expression).toByte(caret - begin);
    background.run(
        0,
        () -> {
          List<Completion> found =
              GuestExpression.of(source, catalogue, line, ByteText.asBytes(expression))
                  .completions(offset);
          dispatch.execute(() -> offered.accept(found));
        });
  }
}
