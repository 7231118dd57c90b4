package org.pendant.desktop.shell.prompt;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.box.MessageCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Reply;
import org.pendant.controller.message.Answer;
import org.pendant.controller.message.Operator;
import org.pendant.controller.message.Popup.Severity;
import org.pendant.script.vm.ProgramState;

final class PromptsTest {
  private final Controller controller =
      new Controller(
          ControllerOptions.headless().withArm(ArmChoice.IDEAL).withOperator(Operator.present()));
  private final Prompts prompts = new Prompts();
  private long nowNs = 1;

  private void start(String... lines) {
    send(
        new ProgramCommand.StartProgram(
            TestController.program(controller, String.join("\n", lines) + "\n")));
  }

  private void send(Command command) {
    var reply = controller.submit(command);
    controller.runUntil(() -> false, 5);
    assertEquals(new Reply.Done(), reply.join());
    prompts.take(controller.state(), nowNs);
  }

  private Prompt shown() {
    return prompts.shown().orElseThrow();
  }

  @Test
  void nothingIsShownAtFirst() {
    prompts.take(controller.state(), nowNs);
    assertEquals(Optional.empty(), prompts.shown());
    assertEquals("", prompts.place());
    assertEquals(Optional.empty(), prompts.close());
    assertEquals(Optional.empty(), prompts.stop());
  }

  @Test
  void popupIsShownInWordsAndClosed() {
    start("popup(\"f\u00fcr dich\", \" \", warning=True, blocking=True)");
    assertEquals("Popup", shown().title());
    assertEquals("f\u00fcr dich", shown().text());
    assertEquals(Severity.WARNING, shown().severity());
    assertTrue(shown().waits());
    send(prompts.close().orElseThrow());
    assertEquals(Optional.empty(), prompts.shown());
    assertEquals(ProgramState.STOPPED, controller.state().program().state());
  }

  @Test
  void theShownOneStaysAndThenWhatTheProgramWaitsForComesFirst() {
    start("popup(\"one\")", "sync()", "popup(\"two\")", "popup(\"three\", blocking=True)");
    assertEquals("three", shown().text(), "all came at once");
    assertEquals("3 of 3", prompts.place());
    send(prompts.close().orElseThrow());
    assertEquals("one", shown().text());
    start("popup(\"four\", blocking=True)");
    assertEquals("one", shown().text());
    assertEquals("1 of 3", prompts.place());
    send(prompts.close().orElseThrow());
    assertEquals("four", shown().text());
  }

  @Test
  void allOfThemCanBeLookedAt() {
    start("popup(\"one\")", "popup(\"two\")", "popup(\"three\")");
    assertEquals("one", shown().text());
    prompts.next(nowNs);
    assertEquals("2 of 3", prompts.place());
    prompts.next(nowNs);
    prompts.next(nowNs);
    assertEquals("1 of 3", prompts.place());
  }

  @Test
  void answersCountOnlyAfterAMomentAndOnce() {
    start("popup(\"one\", blocking=True)");
    assertFalse(prompts.ready(nowNs));
    assertTrue(prompts.ready(nowNs + Prompts.UNREADY_NS));
    assertTrue(prompts.close().isPresent());
    assertFalse(prompts.ready(nowNs + Prompts.UNREADY_NS));
    assertEquals(Optional.empty(), prompts.close());
    assertEquals(Optional.empty(), prompts.stop());
  }

  @Test
  void yesOrNoIsAnswered() {
    start("textmsg(request_boolean_from_primary_client(\"Mark it?\"))");
    assertEquals("The program asks: yes or no?", shown().title());
    assertTrue(shown().yesOrNo());
    assertFalse(shown().typed());
    assertEquals(new Prompts.Entry(Optional.empty(), ""), prompts.enter("yes"));
    send(prompts.answer(true).orElseThrow());
    assertEquals(List.of("\"Mark it?\" is answered: True", "True"), logged());
  }

  private List<String> logged() {
    return controller.logSince(0).stream().map(each -> each.text()).toList();
  }

  @Test
  void numbersAreCheckedBeforeTheyAreSent() {
    start("n = request_integer_from_primary_client(\"How many?\")");
    assertEquals(
        new Prompts.Entry(
            Optional.empty(), "Must be a whole number from -2147483648 to 2147483647"),
        prompts.enter("2.5"));
    assertEquals(Optional.empty(), prompts.answer(true));
    assertEquals(Optional.empty(), prompts.close());
    assertEquals(
        new Prompts.Entry(
            Optional.of(new MessageCommand.AnswerQuestion(shown().number(), new Answer.Whole(12))),
            ""),
        prompts.enter(" 12 "));
  }

  @Test
  void textIsSentAsTheBytesThatScriptsHold() {
    start("textmsg(request_string_from_primary_client(\"Name?\"))");
    send(prompts.enter("\u00e4").command().orElseThrow());
    assertEquals("\u00c3\u00a4", logged().getLast());
  }

  @Test
  void cancellingAQuestionStopsTheProgram() {
    start("request_float_from_primary_client(\"Offset?\")");
    send(prompts.stop().orElseThrow());
    assertEquals(ProgramState.STOPPED, controller.state().program().state());
    assertEquals(Optional.empty(), prompts.shown());
  }

  @Test
  void whatAProgramAskedClosesWithIt() {
    start("request_float_from_primary_client(\"Offset?\")");
    send(new ProgramCommand.StopProgram());
    assertEquals(Optional.empty(), prompts.shown());
  }
}
