package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.box.MessageCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.command.Reply;
import org.pendant.controller.message.Answer;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.Operator;
import org.pendant.controller.message.Popup;
import org.pendant.controller.message.PreparedAnswer;
import org.pendant.controller.message.Question;
import org.pendant.controller.message.Question.Kind;
import org.pendant.language.source.Source;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.ProgramState;

/** Programs that ask the operator (manual 18.73 to 18.76), and the popups that they show. */
final class OperatorInputTest {
  private final List<String> said = new ArrayList<>();
  private Controller controller = controller(Operator.present());

  private static Controller controller(Operator operator) {
    return new Controller(
        ControllerOptions.headless().withArm(ArmChoice.IDEAL).withOperator(operator));
  }

  private LoadResult load(String text) {
    return controller.load(Source.of("ask.script", text.getBytes(StandardCharsets.ISO_8859_1)));
  }

  private void start(String... lines) {
    LoadResult loadResult = load(String.join("\n", lines) + "\n");
    assertTrue(loadResult.program().isPresent(), () -> loadResult.diagnostics().toString());
    assertEquals(
        new Reply.Done(), ask(new ProgramCommand.StartProgram(loadResult.program().get())));
  }

  private void prepared(String... answers) {
    controller =
        controller(Operator.headless(Stream.of(answers).map(PreparedAnswer::new).toList()));
  }

  private void advance(int frames) {
    for (int i = 0; i < frames; i++) {
      controller.advance();
      controller.state().newEntries().stream()
          .filter(entry -> entry.origin() == LogEntry.Origin.SCRIPT)
          .forEach(entry -> said.add(entry.text()));
    }
  }

  private Reply ask(Command command) {
    CompletableFuture<Reply> reply = controller.submit(command);
    advance(1);
    return reply.join();
  }

  private List<Question> open() {
    return controller.state().openQuestions();
  }

  private ProgramState programState() {
    return controller.state().program().state();
  }

  private Ending ending() {
    return controller.state().program().ending().orElseThrow();
  }

  private void answer(Answer answer) {
    assertEquals(
        new Reply.Done(),
        ask(new MessageCommand.AnswerQuestion(open().getFirst().number(), answer)));
    advance(2);
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
    assertEquals(List.of("True42", "1.25bolt!"), said);
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
    advance(100);
    assertEquals(ProgramState.RUNNING, programState());
    answer(new Answer.Bool(true));
    assertEquals(List.of("True"), said);
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
    advance(2);
    assertEquals(2, open().size());
    for (Question each : List.copyOf(open())) {
      Answer length = new Answer.Whole(each.text().length());
      assertEquals(new Reply.Done(), ask(new MessageCommand.AnswerQuestion(each.number(), length)));
    }
    advance(2);
    assertEquals(List.of("main 4", "other 5"), said.stream().sorted().toList());
  }

  @Test
  void wrongAnswerIsRefusedAndTheQuestionStays() {
    start("textmsg(request_integer_from_primary_client(\"How many?\"))");
    long number = open().getFirst().number();
    assertEquals(
        new Reply.Refused(
            Refusal.Code.INVALID,
            "answer is few, must be a whole number from -2147483648 to 2147483647"),
        ask(new MessageCommand.AnswerQuestion(number, new Answer.Text("few"))));
    assertEquals(1, open().size());
    assertEquals(
        new Reply.Refused(Refusal.Code.INVALID, "question " + (number + 1) + " is not open"),
        ask(new MessageCommand.AnswerQuestion(number + 1, new Answer.Whole(1))));
    answer(new Answer.Whole(3));
    assertEquals(List.of("3"), said);
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
    advance(2);
    assertEquals(
        new Reply.Refused(Refusal.Code.INVALID, "question 99 is not open"),
        ask(new MessageCommand.CancelQuestion(99)));
    assertEquals(ProgramState.RUNNING, programState());
    assertEquals(
        new Reply.Done(), ask(new MessageCommand.CancelQuestion(open().getFirst().number())));
    assertInstanceOf(Ending.Stopped.class, ending());
    assertEquals(List.of(), open());
    assertEquals(List.of(), controller.state().openPopups());
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
    advance(3);
    assertEquals(1, open().size());
    advance(12);
    assertEquals(ProgramState.RUNNING, programState());
    assertEquals(List.of(), open());
  }

  @Test
  void answerGivenDuringAPauseCountsWhenTheProgramGoesOn() {
    start("textmsg(request_boolean_from_primary_client(\"Go on?\"))");
    ask(new ProgramCommand.PauseProgram());
    advance(5);
    answer(new Answer.Bool(true));
    assertEquals(List.of(), open());
    assertEquals(List.of(), said);
    ask(new ProgramCommand.ResumeProgram());
    advance(2);
    assertEquals(List.of("True"), said);
  }

  @Test
  void askingTakesTimeSoThatALoopOfQuestionsIsNoEndlessLoop() {
    prepared("Again?=yes");
    start("while request_boolean_from_primary_client(\"Again?\"):", "end");
    advance(50);
    assertEquals(ProgramState.RUNNING, programState());
  }

  @Test
  void preparedAnswersAreUsedAndLogged() {
    prepared("=3", "Which?=bolt");
    start(
        "n = request_integer_from_primary_client(\"How many?\")",
        "textmsg(n, request_string_from_primary_client(\"Which?\"))");
    advance(4);
    assertEquals(List.of("3bolt"), said);
    assertEquals(
        List.of("\"How many?\" is answered: 3", "\"Which?\" is answered: bolt"),
        controller.logSince(0).stream()
            .filter(entry -> entry.origin() == LogEntry.Origin.CONTROLLER)
            .map(LogEntry::text)
            .toList());
  }

  @Test
  void withoutAnAnswerTheProgramFailsAndQuotesTheQuestion() {
    prepared();
    start("x = 1", "request_float_from_primary_client(\"Offset?\")");
    advance(2);
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
    advance(2);
    Ending.Failed failed = assertInstanceOf(Ending.Failed.class, ending());
    assertEquals(
        "request_float_from_primary_client: prepared for \"Offset?\": answer is far, must be a"
            + " number such as -12.5 or 2e-3",
        failed.failure().message());
  }

  @Test
  void emptyMessageIsRefused() {
    start("request_string_from_primary_client(\"\")");
    advance(1);
    Ending.Failed failed = assertInstanceOf(Ending.Failed.class, ending());
    assertEquals(
        "request_string_from_primary_client: message is empty, must say what to answer",
        failed.failure().message());
    assertEquals(List.of(), open());
  }

  @Test
  void secondaryProgramMayNotAsk() {
    LoadResult loadResult = load("sec s():\n  request_string_from_primary_client(\"x\")\nend\n");
    assertTrue(loadResult.program().isEmpty());
  }

  @Test
  void popupThatDoesNotBlockOutlivesAProgramThatEndsByItself() {
    start("popup(\"done\")");
    advance(3);
    assertEquals(ProgramState.STOPPED, programState());
    assertEquals(List.of("done"), openPopups());
    start("sleep(1)");
    ask(new ProgramCommand.StopProgram());
    assertEquals(List.of(), openPopups());
  }

  @Test
  void programThatIsStoppedAndStartedInOneFrameLosesItsPopupsAndItsMove() {
    start("popup(\"old\")", "movej([1, -1.5, -1.5, -1.5, 1.5, 0])");
    advance(100);
    assertTrue(controller.state().arm().moving());
    var _ = controller.submit(new ProgramCommand.StopProgram());
    start("sleep(2)");
    assertEquals(List.of(), openPopups());
    advance(900);
    assertFalse(controller.state().arm().moving());
    assertEquals(ProgramState.RUNNING, programState());
  }

  private List<String> openPopups() {
    return controller.state().openPopups().stream().map(Popup::text).toList();
  }
}
