package org.pendant.desktop.shell.prompt;

import static org.pendant.desktop.shell.prompt.PromptTexts.text;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.box.MessageCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.message.Answer;
import org.pendant.controller.message.Popup;
import org.pendant.controller.message.Question;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.ByteText;

/**
 * Prompts: popups and questions in a queue, one of which is shown. It stays until it is closed or
 * people continue to another one; then what the program waits for comes first, and what is older.
 */
final class Prompts {
  /** Keys and clicks shortly after one appears were meant for something else. */
  static final long UNREADY_NS = TimeUnit.MILLISECONDS.toNanos(400);

  private List<Popup> popups = List.of();
  private List<Question> questions = List.of();
  private List<Prompt> open = List.of();
  private Optional<Prompt> shown = Optional.empty();
  private long shownAtNs;
  private boolean answered;

  /**
   * An answer that was typed.
   *
   * @param command that gives it; empty when it was refused
   * @param error why it was refused; empty when it was not
   */
  record Entry(Optional<Command> command, String error) {}

  /**
   * Takes what is open.
   *
   * @param nowNs time of any clock
   */
  void take(ControllerState state, long nowNs) {
    if (popups.equals(state.openPopups()) && questions.equals(state.openQuestions())) {
      return;
    }
    popups = state.openPopups();
    questions = state.openQuestions();
    open =
        Stream.concat(popups.stream().map(Prompt::of), questions.stream().map(Prompt::of))
            .sorted(Comparator.comparingLong(Prompt::number))
            .toList();
    if (shown.isEmpty() || !open.contains(shown.get())) {
      show(open.stream().filter(Prompt::waits).findFirst().or(() -> first(open)), nowNs);
    }
  }

  private static Optional<Prompt> first(List<Prompt> prompts) {
    return prompts.stream().findFirst();
  }

  private void show(Optional<Prompt> prompt, long nowNs) {
    shown = prompt;
    shownAtNs = nowNs;
    answered = false;
  }

  /** The one to look at. */
  Optional<Prompt> shown() {
    return shown;
  }

  /** Which one of how many is shown, such as {@code 1 of 3}; empty for the only one. */
  String place() {
    return open.size() > 1
        ? text("promptOfPrompts", shown.map(open::indexOf).orElse(0) + 1, open.size())
        : "";
  }

  /** Shows the next one, and after the last the first. */
  void next(long nowNs) {
    if (open.size() > 1) {
      int after = (shown.map(open::indexOf).orElse(0) + 1) % open.size();
      show(Optional.of(open.get(after)), nowNs);
    }
  }

  /** Whether an answer counts: it is there long enough, and none was given. */
  boolean ready(long nowNs) {
    return shown.isPresent() && !answered && nowNs - shownAtNs >= UNREADY_NS;
  }

  /** Closes a popup; a program that waits for it continues. */
  Optional<Command> close() {
    return command(
        shown
            .filter(each -> each.kind().isEmpty())
            .map(each -> new MessageCommand.AnswerPopup(each.number())));
  }

  /** Answers by yes or no. */
  Optional<Command> answer(boolean yes) {
    return command(
        shown
            .filter(Prompt::yesOrNo)
            .map(each -> new MessageCommand.AnswerQuestion(each.number(), new Answer.Bool(yes))));
  }

  /** Ends the program instead of answering. */
  Optional<Command> stop() {
    return command(
        shown.map(
            each ->
                each.kind().isPresent()
                    ? new MessageCommand.CancelQuestion(each.number())
                    : new ProgramCommand.StopProgram()));
  }

  private Optional<Command> command(Optional<Command> command) {
    if (answered) {
      return Optional.empty();
    }
    answered = command.isPresent();
    return command;
  }

  /** Answers by what was typed. */
  Entry enter(String text) {
    Optional<Prompt> asked = shown.filter(Prompt::typed);
    if (asked.isEmpty()) {
      return new Entry(Optional.empty(), "");
    }
    Question.Kind kind = asked.get().kind().orElseThrow();
    try {
      Answer answer = kind.read(ByteText.asBytes(text));
      long number = asked.get().number();
      return new Entry(command(Optional.of(new MessageCommand.AnswerQuestion(number, answer))), "");
    } catch (IllegalArgumentException e) {
      return new Entry(Optional.empty(), text("mustBe", kind.expected()));
    }
  }
}
