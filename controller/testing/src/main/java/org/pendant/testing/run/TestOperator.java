package org.pendant.testing.run;

import static org.pendant.testing.run.TestRunTexts.text;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.bench.PreparedAnswers;
import org.pendant.controller.box.MessageCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.message.Popup;
import org.pendant.controller.message.Question;
import org.pendant.controller.state.ControllerState;
import org.pendant.script.vm.ProgramState;

/** Operator of a test: closes popups and gives the answers that the test has prepared. */
final class TestOperator {
  private final PreparedAnswers answers;
  private final boolean watched;
  private final Set<Long> answered = new HashSet<>();
  private final List<Thought> thoughts = new ArrayList<>();

  /**
   * An answer that comes later.
   *
   * @param frame after which it is given
   */
  private record Thought(long frame, MessageCommand.AnswerQuestion answer) {}

  /**
   * An operator.
   *
   * @param watched whether a test watches the program, and so continues it itself after a pause
   */
  TestOperator(PreparedAnswers answers, boolean watched) {
    this.answers = answers;
    this.watched = watched;
  }

  /**
   * Does what is to be done after a frame.
   *
   * @param post takes commands
   * @return why it is at a loss
   */
  Optional<String> look(ControllerState state, Consumer<Command> post) {
    boolean blocked = false;
    for (Popup each : state.openPopups()) {
      blocked |= each.blocking();
      if (!answers.popupsStay() && answered.add(each.number())) {
        post.accept(new MessageCommand.AnswerPopup(each.number()));
      }
    }
    if (!watched
        && !blocked
        && state.program().state() == ProgramState.PAUSED
        && state.safety().stop().isEmpty()) {
      // nobody is here to continue a test that pauses itself
      post.accept(new ProgramCommand.ResumeProgram());
    }
    for (Question each : state.openQuestions()) {
      if (answered.add(each.number())) {
        Optional<String> refusal = answer(each, state.frame());
        if (refusal.isPresent()) {
          return refusal;
        }
      }
    }
    say(state, post);
    return Optional.empty();
  }

  /** Gives the answers that are due; one whose question was withdrawn is forgotten. */
  private void say(ControllerState state, Consumer<Command> post) {
    for (Thought each : List.copyOf(thoughts)) {
      if (each.frame() <= state.frame()) {
        thoughts.remove(each);
        long number = each.answer().number();
        if (state.openQuestions().stream().anyMatch(open -> open.number() == number)) {
          post.accept(each.answer());
        }
      }
    }
  }

  private Optional<String> answer(Question question, long frame) {
    Optional<PreparedAnswers.Given> given = answers.take(question.text());
    if (given.isEmpty()) {
      return Optional.of(text("asksWithoutAnswer", question.text()));
    }
    try {
      // what is posted after a frame comes into force in the next one
      thoughts.add(
          new Thought(
              frame + given.get().afterFrames() - 1,
              new MessageCommand.AnswerQuestion(
                  question.number(), question.kind().read(given.get().value()))));
      return Optional.empty();
    } catch (IllegalArgumentException e) {
      return Optional.of(text("wrongAnswer", question.text(), e.getMessage()));
    }
  }
}
