package org.pendant.controller.message;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.pendant.controller.message.Popup.Severity;
import org.pendant.controller.message.Question.Kind;

final class PromptQueueTest {
  private final MessageLog log = new MessageLog();
  private final PromptNumbers numbers = new PromptNumbers();
  private final PromptQueue board = new PromptQueue(Operator.present(), log, numbers);

  private PromptQueue prepared(String... lines) {
    return new PromptQueue(
        Operator.headless(Stream.of(lines).map(PreparedAnswer::new).toList()), log, numbers);
  }

  private static void refused(String message, Runnable action) {
    assertEquals(message, assertThrows(IllegalArgumentException.class, action::run).getMessage());
  }

  @Test
  void answersByNumberWhileOthersStayOpen() {
    PendingPrompt parts = board.ask(0, Kind.INTEGER, "How many parts?");
    PendingPrompt name = board.ask(0, Kind.STRING, "Which part?");
    assertEquals(List.of(parts.question(), name.question()), board.open());
    board.answer(name.question().number(), new Answer.Text("bolt"));
    assertEquals(Optional.of(new Answer.Text("bolt")), name.answer());
    assertEquals(List.of(parts.question()), board.open());
    assertEquals("\"Which part?\" is answered: bolt", log.since(0).getLast().text());
  }

  @Test
  void staysOpenAfterAnAnswerOfAnotherKind() {
    PendingPrompt parts = board.ask(0, Kind.INTEGER, "How many parts?");
    refused(
        "answer is True, must be a whole number from -2147483648 to 2147483647",
        () -> board.answer(1, new Answer.Bool(true)));
    refused(
        "answer is 2.0, must be a whole number from -2147483648 to 2147483647",
        () -> board.answer(1, new Answer.Decimal(2)));
    assertEquals(List.of(parts.question()), board.open());
    refused("question 7 is not open", () -> board.answer(7, new Answer.Whole(1)));
  }

  @Test
  void takesAWholeNumberForANumberButNoneThatIsNotFinite() {
    PendingPrompt offset = board.ask(0, Kind.FLOAT, "Offset?");
    refused(
        "answer is NaN, must be a number such as -12.5 or 2e-3",
        () -> board.answer(1, new Answer.Decimal(Double.NaN)));
    board.answer(1, new Answer.Whole(3));
    assertEquals(Optional.of(new Answer.Decimal(3)), offset.answer());
  }

  @Test
  void countsPopupsAndQuestionsTogether() {
    OpenPopups popups = new OpenPopups(Operator.present(), log, numbers);
    assertEquals(1, popups.show(0, "T", "t", Severity.MESSAGE, false).number());
    assertEquals(2, board.ask(0, Kind.BOOLEAN, "Go on?").question().number());
    assertEquals(3, popups.show(0, "T", "t", Severity.MESSAGE, false).number());
  }

  @Test
  void handsOutEachQuestionOnceForTheSnapshot() {
    PromptQueue absent = prepared("Go on?=yes");
    Question asked = absent.ask(0, Kind.BOOLEAN, "Go on?").question();
    assertEquals(List.of(asked), absent.takeNew());
    assertEquals(List.of(), absent.takeNew());
    assertEquals(List.of(), absent.open());
  }

  @Test
  void withdrawnQuestionIsNotOpenAnyMore() {
    PendingPrompt pendingPrompt = board.ask(0, Kind.BOOLEAN, "Go on?");
    board.withdraw(pendingPrompt);
    assertEquals(List.of(), board.open());
    refused("question 1 is not open", () -> board.cancel(1));
  }

  @Test
  void findsPreparedAnswersByTextAndThenInOrder() {
    PromptQueue absent = prepared("=first", "Which?=named", "=second");
    assertEquals("named", text(absent.ask(0, Kind.STRING, "Which?")));
    assertEquals("first", text(absent.ask(0, Kind.STRING, "Where?")));
    assertEquals("named", text(absent.ask(0, Kind.STRING, "Which?")));
    assertEquals("second", text(absent.ask(0, Kind.STRING, "When?")));
    assertEquals(
        Optional.of("nobody is here to answer \"Why?\", and no answer is prepared"),
        absent.ask(0, Kind.STRING, "Why?").refusal());
  }

  @Test
  void usesAnswersToTheSameTextOneAfterTheOtherAndTheLastOneFromThenOn() {
    PromptQueue absent = prepared("More?=yes", "More?=no");
    assertEquals("True", text(absent.ask(0, Kind.BOOLEAN, "More?")));
    assertEquals("False", text(absent.ask(0, Kind.BOOLEAN, "More?")));
    assertEquals("False", text(absent.ask(0, Kind.BOOLEAN, "More?")));
  }

  @Test
  void readsAnswersWhoseTextAndValueHaveEqualSigns() {
    assertEquals("c=d", text(prepared("a=b=c=d").ask(0, Kind.STRING, "a=b")));
    assertThrows(IllegalArgumentException.class, () -> new PreparedAnswer("without"));
  }

  @Test
  void refusesAPreparedAnswerOfAnotherKind() {
    assertEquals(
        Optional.of(
            "prepared for \"How many?\": answer is few, must be a whole number from -2147483648 to"
                + " 2147483647"),
        prepared("How many?=few").ask(0, Kind.INTEGER, "How many?").refusal());
  }

  @Test
  void readsWrittenAnswersOfEachKind() {
    assertEquals(new Answer.Bool(true), Kind.BOOLEAN.read(" True "));
    assertEquals(new Answer.Bool(false), Kind.BOOLEAN.read("no"));
    assertEquals(new Answer.Whole(-7), Kind.INTEGER.read(" -007 "));
    assertEquals(new Answer.Whole(Integer.MAX_VALUE), Kind.INTEGER.read("2147483647"));
    assertEquals(new Answer.Decimal(-12.5), Kind.FLOAT.read("-12.5"));
    assertEquals(new Answer.Decimal(0.002), Kind.FLOAT.read("2e-3"));
    assertEquals(new Answer.Decimal(.5), Kind.FLOAT.read(".5"));
    assertEquals(new Answer.Text(" as it is "), Kind.STRING.read(" as it is "));
    assertEquals(new Answer.Text(""), Kind.STRING.read(""));
  }

  @Test
  void refusesWrittenAnswersThatAreNone() {
    for (String text : List.of("", "maybe", "2", "Truee")) {
      assertThrows(IllegalArgumentException.class, () -> Kind.BOOLEAN.read(text), text);
    }
    for (String text : List.of("", "1.5", "2147483648", "-2147483649", "1e3", "99999999999999")) {
      assertThrows(IllegalArgumentException.class, () -> Kind.INTEGER.read(text), text);
    }
    for (String text : List.of("", ".", "1,5", "NaN", "Infinity", "1e999", "0x10", "1d", "--1")) {
      assertThrows(IllegalArgumentException.class, () -> Kind.FLOAT.read(text), text);
    }
    assertThrows(IllegalArgumentException.class, () -> Kind.STRING.read("\u20ac"));
  }

  private static String text(PendingPrompt pendingPrompt) {
    assertTrue(pendingPrompt.answer().isPresent(), () -> pendingPrompt.refusal().orElse("open"));
    return pendingPrompt.answer().get().text();
  }
}
