package org.pendant.desktop.shell.prompt;

import java.util.Optional;
import org.pendant.controller.message.Popup;
import org.pendant.controller.message.Popup.Severity;
import org.pendant.controller.message.Question;
import org.pendant.language.source.ByteText;

/**
 * Prompt: a popup or a question, in words for people.
 *
 * @param number under which it is answered
 * @param kind which answers it takes, for a question
 * @param waits whether the program, or a thread of it, waits for the answer
 * @param title never blank
 */
record Prompt(
    long number,
    Optional<Question.Kind> kind,
    Severity severity,
    boolean waits,
    String title,
    String text) {

  static Prompt of(Popup popup) {
    String title = ByteText.decoded(popup.title());
    return new Prompt(
        popup.number(),
        Optional.empty(),
        popup.severity(),
        popup.blocking(),
        title.isBlank() ? PromptTexts.text("popup") : title,
        ByteText.decoded(popup.text()));
  }

  static Prompt of(Question question) {
    String title =
        switch (question.kind()) {
          case BOOLEAN -> PromptTexts.text("theProgramAsksYesOrNo");
          case INTEGER -> PromptTexts.text("theProgramAsksForAWhole");
          case FLOAT -> PromptTexts.text("theProgramAsksForANumber");
          case STRING -> PromptTexts.text("theProgramAsksForAText");
        };
    return new Prompt(
        question.number(),
        Optional.of(question.kind()),
        Severity.MESSAGE,
        true,
        title,
        ByteText.decoded(question.text()));
  }

  /** Whether it is answered by yes or no. */
  boolean yesOrNo() {
    return kind.filter(each -> each == Question.Kind.BOOLEAN).isPresent();
  }

  /** Whether it is answered by typing. */
  boolean typed() {
    return kind.isPresent() && !yesOrNo();
  }
}
