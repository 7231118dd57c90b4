package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.box.MessageCommand;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.command.Reply;
import org.pendant.controller.message.Answer;
import org.pendant.controller.message.Operator;
import org.pendant.controller.message.Popup;
import org.pendant.controller.message.PreparedAnswer;
import org.pendant.controller.message.Question;
import org.pendant.controller.message.Question.Kind;
import org.pendant.language.source.Source;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.ProgramState;

/** Programs that ask the operator (manual 18.73 to 18.76), and the popups that they show. */
final class OperatorInputTest {
  private RunningProgram running = running(Operator.present());

  private static RunningProgram running(Operator operator) {
    return new RunningProgram(
        ControllerOptions.headless().withArm(ArmChoice.IDEAL).withOperator(operator));
  }

  private void start(String... lines) {
    running.start(String.join("\n", lines) + "\n");
  }

  private void prepared(String... answers) {
    running = running(Operator.headless(Stream.of(answers).map(PreparedAnswer::new).toList()));
  }

  private List<Question> open() {
    return running.state().openQuestions();
  }

  private ProgramState programState() {
    return running.state().program().state();
  }

  private Ending ending() {
    return running.state().program().ending().orElseThrow();
  }

  private void answer(Answer answer) {
    assertEquals(
        new Reply.Done(),
        running.ask(new MessageCommand.AnswerQuestion(open().getFirst().number(), answer)));
    running.advance(2);
  }

  @Test
  void asksForEachKindOfAnswerAndGetsIt() {
    start(
        "b = request_boolean_from_primary_client(\"Mark it?\")",
        "i = request_integer_from_primary_client(\"How many?\")",
        "f = request_float_from_primary_client(\"Offset [mm]\")",
        "s = request_string_from_primary_client(\"Which part?\")",
        "textmsg(not b, i + 1)",
        "textmsg(f / 2, str_cat(s, \"!\"))");
    assertEquals(Kind.BOOLEAN, open().getFirst().kind());
    assertEquals("Mark it?", open().getFirst().text());
    answer(new Answer.Bool(false));
    assertEquals(Kind.INTEGER, open().getFirst().kind());
    answer(new Answer.Whole(41));
    assertEquals(Kind.FLOAT, open().getFirst().kind());
    answer(new Answer.Decimal(2.5));
    assertEquals(Kind.STRING, open().getFirst().kind());
    answer(new Answer.Text("bolt"));
    assertEquals(List.of("True42", "1.25bolt!"), running.said());
    assertEquals(ProgramState.STOPPED, programState());
    assertEquals(List.of(), open());
  }

  @Test
  void onlyTheAskingThreadWaits() {
    start(
        "global n = 0",
        "thread count():",
        "  while True:",
        "    n = n + 1",
        "    sync()",
        "  end",
        "end",
        "run count()",
        "request_boolean_from_primary_client(\"Enough?\")",
        "textmsg(n > 90)");
    running.advance(100);
    assertEquals(ProgramState.RUNNING, programState());
    answer(new Answer.Bool(true));
    assertEquals(List.of("True"), running.said());
  }

  @Test
  void answersToSeveralThreadsGoWhereTheyBelong() {
    start(
        "thread other():",
        "  textmsg(\"other \", request_integer_from_primary_client(\"other\"))",
        "end",
        "h = run other()",
        "textmsg(\"main \", request_integer_from_primary_client(\"main\"))",
        "join h");
    running.advance(2);
    assertEquals(2, open().size());
    for (Question each : List.copyOf(open())) {
      Answer length = new Answer.Whole(each.text().length());
      assertEquals(
          new Reply.Done(), running.ask(new MessageCommand.AnswerQuestion(each.number(), length)));
    }
    running.advance(2);
    assertEquals(List.of("main 4", "other 5"), running.said().stream().sorted().toList());
  }

  @Test
  void wrongAnswerIsRefusedAndTheQuestionStays() {
    start("textmsg(request_integer_from_primary_client(\"How many?\"))");
    long number = open().getFirst().number();
    assertEquals(
        new Reply.Refused(
            Refusal.Code.INVALID,
            "answer is few, must be a whole number from -2147483648 to 2147483647"),
        running.ask(new MessageCommand.AnswerQuestion(number, new Answer.Text("few"))));
    assertEquals(1, open().size());
    assertEquals(
        new Reply.Refused(Refusal.Code.INVALID, "question " + (number + 1) + " is not open"),
        running.ask(new MessageCommand.AnswerQuestion(number + 1, new Answer.Whole(1))));
    answer(new Answer.Whole(3));
    assertEquals(List.of("3"), running.said());
  }

  @Test
  void cancelStopsTheProgramAndClosesWhatItAsked() {
    start(
        "popup(\"look\")",
        "thread other():",
        "  request_string_from_primary_client(\"other\")",
        "end",
        "run other()",
        "request_string_from_primary_client(\"main\")");
    running.advance(2);
    assertEquals(
        new Reply.Refused(Refusal.Code.INVALID, "question 99 is not open"),
        running.ask(new MessageCommand.CancelQuestion(99)));
    assertEquals(ProgramState.RUNNING, programState());
    assertEquals(
        new Reply.Done(),
        running.ask(new MessageCommand.CancelQuestion(open().getFirst().number())));
    assertInstanceOf(Ending.Stopped.class, ending());
    assertEquals(List.of(), open());
    assertEquals(List.of(), running.state().openPopups());
  }

  @Test
  void questionOfAKilledThreadCloses() {
    start(
        "thread other():",
        "  request_string_from_primary_client(\"other\")",
        "end",
        "h = run other()",
        "sleep(0.02)",
        "kill h",
        "sleep(1)");
    running.advance(3);
    assertEquals(1, open().size());
    running.advance(12);
    assertEquals(ProgramState.RUNNING, programState());
    assertEquals(List.of(), open());
  }

  @Test
  void answerGivenDuringAPauseCountsWhenTheProgramGoesOn() {
    start("textmsg(request_boolean_from_primary_client(\"Go on?\"))");
    running.ask(new ProgramCommand.PauseProgram());
    running.advance(5);
    answer(new Answer.Bool(true));
    assertEquals(List.of(), open());
    assertEquals(List.of(), running.said());
    running.ask(new ProgramCommand.ResumeProgram());
    running.advance(2);
    assertEquals(List.of("True"), running.said());
  }

  @Test
  void askingTakesTimeSoThatALoopOfQuestionsIsNoEndlessLoop() {
    prepared("Again?=yes");
    start("while request_boolean_from_primary_client(\"Again?\"):", "end");
    running.advance(50);
    assertEquals(ProgramState.RUNNING, programState());
  }

  @Test
  void preparedAnswersAreUsedAndLogged() {
    prepared("=3", "Which?=bolt");
    start(
        "n = request_integer_from_primary_client(\"How many?\")",
        "textmsg(n, request_string_from_primary_client(\"Which?\"))");
    running.advance(4);
    assertEquals(List.of("3bolt"), running.said());
    assertEquals(
        List.of("\"How many?\" is answered: 3", "\"Which?\" is answered: bolt"),
        running.reported());
  }

  @Test
  void withoutAnAnswerTheProgramFailsAndQuotesTheQuestion() {
    prepared();
    start("x = 1", "request_float_from_primary_client(\"Offset?\")");
    running.advance(2);
    Ending.Failed failed = assertInstanceOf(Ending.Failed.class, ending());
    assertEquals(
        "request_float_from_primary_client: nobody is here to answer \"Offset?\", and no answer is"
            + " prepared",
        failed.failure().message());
    assertEquals(2, failed.failure().line());
    assertEquals("no-answer", failed.failure().code());
  }

  @Test
  void preparedAnswerOfAnotherKindFailsTheProgram() {
    prepared("Offset?=far");
    start("request_float_from_primary_client(\"Offset?\")");
    running.advance(2);
    Ending.Failed failed = assertInstanceOf(Ending.Failed.class, ending());
    assertEquals(
        "request_float_from_primary_client: prepared for \"Offset?\": answer is far, must be a"
            + " number such as -12.5 or 2e-3",
        failed.failure().message());
  }

  @Test
  void emptyMessageIsRefused() {
    start("request_string_from_primary_client(\"\")");
    running.advance(1);
    Ending.Failed failed = assertInstanceOf(Ending.Failed.class, ending());
    assertEquals(
        "request_string_from_primary_client: message is empty, must say what to answer",
        failed.failure().message());
    assertEquals(List.of(), open());
  }

  @Test
  void secondaryProgramMayNotAsk() {
    Robot robot = new Controller(ControllerOptions.headless());
    String text = "sec s():\n  request_string_from_primary_client(\"x\")\nend\n";
    assertTrue(robot.load(Source.of("ask.script", text)).program().isEmpty());
  }

  @Test
  void popupThatDoesNotBlockOutlivesAProgramThatEndsByItself() {
    start("popup(\"done\")");
    running.advance(3);
    assertEquals(ProgramState.STOPPED, programState());
    assertEquals(List.of("done"), openPopups());
    start("sleep(1)");
    running.ask(new ProgramCommand.StopProgram());
    assertEquals(List.of(), openPopups());
  }

  @Test
  void programThatIsStoppedAndStartedInOneFrameLosesItsPopupsAndItsMove() {
    start("popup(\"old\")", "movej([1, -1.5, -1.5, -1.5, 1.5, 0])");
    running.advance(100);
    assertTrue(running.state().arm().moving());
    var _ = running.submit(new ProgramCommand.StopProgram());
    start("sleep(2)");
    assertEquals(List.of(), openPopups());
    running.advance(900);
    assertFalse(running.state().arm().moving());
    assertEquals(ProgramState.RUNNING, programState());
  }

  private List<String> openPopups() {
    return running.state().openPopups().stream().map(Popup::text).toList();
  }
}
