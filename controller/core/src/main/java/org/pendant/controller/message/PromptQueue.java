package org.pendant.controller.message;

import static org.pendant.controller.message.MessageTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Prompt queue: the questions to the operator that wait for an answer. Owned by the frame loop. */
public final class PromptQueue {
  /** Questions of a frame with a prepared answer that are told; more are answered all the same. */
  private static final int MAX_TOLD = 64;

  /** Bytes of a text that are asked. */
  private static final int MAX_TEXT = 4096;

  private final Optional<ScriptedAnswers> sheet;
  private final MessageLog log;
  private final PromptNumbers numbers;
  private final List<PendingPrompt> waiting = new ArrayList<>();
  private List<Question> open = List.of();
  private List<Question> fresh = new ArrayList<>();

  /**
   * No questions yet.
   *
   * @param log is told the answers
   * @param numbers shared with the popups
   */
  public PromptQueue(Operator operator, MessageLog log, PromptNumbers numbers) {
    sheet =
        switch (operator) {
          case Operator.Present present -> Optional.empty();
          case Operator.Absent absent -> Optional.of(new ScriptedAnswers(absent.answers()));
        };
    this.log = log;
    this.numbers = numbers;
  }

  /**
   * Asks; where no operator is there, a prepared answer is given at once.
   *
   * @param text bytes, one {@code char} a byte; not empty
   */
  public PendingPrompt ask(double timeS, Question.Kind kind, String text) {
    String shown = LogEntry.shortened(text, MAX_TEXT);
    PendingPrompt pendingPrompt =
        new PendingPrompt(new Question(numbers.next(), timeS, kind, shown));
    if (sheet.isEmpty() || fresh.size() < MAX_TOLD) {
      fresh.add(pendingPrompt.question());
    }
    if (sheet.isPresent()) {
      answerFrom(sheet.get(), pendingPrompt);
    } else {
      waiting.add(pendingPrompt);
      publish();
    }
    return pendingPrompt;
  }

  private void answerFrom(ScriptedAnswers answers, PendingPrompt pendingPrompt) {
    String text = pendingPrompt.question().text();
    Optional<String> value = answers.next(text);
    if (value.isEmpty()) {
      pendingPrompt.refuse(text("nobodyAnswers", text));
      return;
    }
    try {
      give(pendingPrompt, pendingPrompt.question().kind().read(value.get()));
    } catch (IllegalArgumentException e) {
      pendingPrompt.refuse(text("preparedFor", text, e.getMessage()));
    }
  }

  /**
   * Answers question {@code number}; it stays open when the answer is refused.
   *
   * @throws IllegalArgumentException if it is not open, or if it does not take this answer
   */
  public void answer(long number, Answer answer) {
    PendingPrompt pendingPrompt = find(number);
    give(pendingPrompt, pendingPrompt.question().kind().fitting(answer));
    withdraw(pendingPrompt);
  }

  private void give(PendingPrompt pendingPrompt, Answer answer) {
    pendingPrompt.answer(answer);
    log.info(text("answered", pendingPrompt.question().text(), answer.text()));
  }

  /**
   * The operator does not want to answer; the caller stops the program.
   *
   * @throws IllegalArgumentException if question {@code number} is not open
   */
  public void cancel(long number) {
    PendingPrompt pendingPrompt = find(number);
    withdraw(pendingPrompt);
    log.info(text("cancelled", pendingPrompt.question().text()));
  }

  private PendingPrompt find(long number) {
    return waiting.stream()
        .filter(each -> each.question().number() == number)
        .findFirst()
        .orElseThrow(() -> new IllegalArgumentException(text("questionNotOpen", number)));
  }

  /** Takes a question back: the thread that asked it has ended. */
  public void withdraw(PendingPrompt pendingPrompt) {
    waiting.remove(pendingPrompt);
    publish();
  }

  private void publish() {
    open = waiting.stream().map(PendingPrompt::question).toList();
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
