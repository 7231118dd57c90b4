package org.pendant.controller.message;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** The questions that wait for an answer, owned by the frame loop. */
public final class QuestionBoard {
  /** Questions of a frame with a prepared answer that are told; more are answered all the same. */
  private static final int MOST_TOLD = 64;

  /** Bytes of a text that are asked. */
  private static final int LONGEST_TEXT = 4096;

  private final Optional<AnswerSheet> sheet;
  private final MessageLog log;
  private final PromptNumbers numbers;
  private final List<Asked> waiting = new ArrayList<>();
  private List<Question> open = List.of();
  private List<Question> fresh = new ArrayList<>();

  /**
   * No questions yet.
   *
   * @param log is told the answers
   * @param numbers shared with the popups
   */
  public QuestionBoard(Operator operator, MessageLog log, PromptNumbers numbers) {
    sheet =
        switch (operator) {
          case Operator.Present present -> Optional.empty();
          case Operator.Absent absent -> Optional.of(new AnswerSheet(absent.answers()));
        };
    this.log = log;
    this.numbers = numbers;
  }

  /**
   * Asks; where nobody is there, a prepared answer is given at once.
   *
   * @param text bytes, one {@code char} a byte; not empty
   */
  public Asked ask(double timeS, Question.Kind kind, String text) {
    String shown = LogEntry.shortened(text, LONGEST_TEXT);
    Asked asked = new Asked(new Question(numbers.next(), timeS, kind, shown));
    if (sheet.isEmpty() || fresh.size() < MOST_TOLD) {
      fresh.add(asked.question());
    }
    if (sheet.isPresent()) {
      answerFrom(sheet.get(), asked);
    } else {
      waiting.add(asked);
      publish();
    }
    return asked;
  }

  private void answerFrom(AnswerSheet answers, Asked asked) {
    String text = asked.question().text();
    Optional<String> value = answers.next(text);
    if (value.isEmpty()) {
      asked.refuse("nobody is here to answer \"" + text + "\", and no answer is prepared");
      return;
    }
    try {
      give(asked, asked.question().kind().read(value.get()));
    } catch (IllegalArgumentException e) {
      asked.refuse("prepared for \"" + text + "\": " + e.getMessage());
    }
  }

  /**
   * Answers question {@code number}; it stays open when the answer is refused.
   *
   * @throws IllegalArgumentException if it is not open, or if it does not take this answer
   */
  public void answer(long number, Answer answer) {
    Asked asked = find(number);
    give(asked, asked.question().kind().fitting(answer));
    withdraw(asked);
  }

  private void give(Asked asked, Answer answer) {
    asked.answer(answer);
    log.info("\"" + asked.question().text() + "\" is answered: " + answer.text());
  }

  /**
   * The operator does not want to answer; whoever calls this stops the program.
   *
   * @throws IllegalArgumentException if question {@code number} is not open
   */
  public void cancel(long number) {
    Asked asked = find(number);
    withdraw(asked);
    log.info("\"" + asked.question().text() + "\" is cancelled, the program stops");
  }

  private Asked find(long number) {
    return waiting.stream()
        .filter(each -> each.question().number() == number)
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException("question " + number + " is not open"));
  }

  /** Takes a question back: the thread that asked it has ended. */
  public void withdraw(Asked asked) {
    waiting.remove(asked);
    publish();
  }

  private void publish() {
    open = waiting.stream().map(Asked::question).toList();
  }

  /** Those that wait for an answer, oldest first. */
  public List<Question> open() {
    return open;
  }

  /** What was asked since the last call, answered or not; for the frame's snapshot. */
  public List<Question> takeNew() {
    if (fresh.isEmpty()) {
      return List.of();
    }
    List<Question> taken = List.copyOf(fresh);
    fresh = new ArrayList<>();
    return taken;
  }
}
