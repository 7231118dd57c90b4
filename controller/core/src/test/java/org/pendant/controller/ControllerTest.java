package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.box.MessageCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.command.Reply;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.Operator;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.Source;
import org.pendant.models.arm.Joints;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramState;

final class ControllerTest {
  private static final long LONG = 100_000;
  private static final String MOVE =
      """
      def move():
        movej([1, -1, -1, -1, 1, 1])
        textmsg("there")
      end
      """;

  private Controller controller = new Controller(ControllerOptions.headless());
  private final List<String> lines = new ArrayList<>();

  private static Program program(Controller controller, String text) {
    LoadResult loadResult =
        controller.load(Source.of("test.script", text.getBytes(StandardCharsets.ISO_8859_1)));
    assertTrue(loadResult.program().isPresent(), () -> loadResult.diagnostics().toString());
    return loadResult.program().get();
  }

  private void advance() {
    controller.advance();
    controller.state().newEntries().stream().map(LogEntry::text).forEach(lines::add);
  }

  private void advance(int frames) {
    for (int i = 0; i < frames; i++) {
      advance();
    }
  }

  private Reply command(Command command) {
    CompletableFuture<Reply> reply = controller.submit(command);
    assertFalse(reply.isDone());
    advance();
    return reply.getNow(new Reply.Busy("no reply"));
  }

  private void start(String text) {
    assertEquals(
        new Reply.Done(), command(new ProgramCommand.StartProgram(program(controller, text))));
  }

  private ControllerState run(String text) {
    start(text);
    while (!ended() && controller.state().frame() < LONG) {
      advance();
    }
    assertTrue(ended(), "still running");
    return controller.state();
  }

  private boolean ended() {
    return controller.state().program().ending().isPresent() && !controller.state().arm().moving();
  }

  private String failure() {
    Ending ending = controller.state().program().ending().orElseThrow();
    return assertInstanceOf(Ending.Failed.class, ending).failure().message();
  }

  private boolean moving() {
    return !controller.state().arm().targetSpeedRadPerS().equals(Joints.ZERO);
  }

  @Test
  void aLoopThatNeverWaitsIsNotTakenForTheLineBeforeIt() {
    Program spins = program(controller, "a = 1\n\nwhile True:\n  a = a + 1\nend\n");
    var _ = controller.submit(new ProgramCommand.StartProgram(spins));
    advance(3);
    assertEquals(4, controller.state().program().line());
  }

  @Test
  void aMoveTakesAsManyFramesAsItsProfile() {
    // 1 rad at 1 rad/s with ramps of 0.5 s: 1.5 s, and the script continues in the frame after it
    run(
        """
        q = get_target_joint_positions()
        q[5] = 1
        movej(q, a=2, v=1)
        textmsg(str_cat(time().sec, " "), time().nanosec)
        """);
    assertEquals(List.of("1 502000000"), lines);
  }

  @Test
  void stoppingAProgramBringsTheArmToRestOnItsPath() {
    start(MOVE);
    advance(200);
    assertTrue(moving());
    assertEquals(new Reply.Done(), command(new ProgramCommand.StopProgram()));
    assertInstanceOf(Ending.Stopped.class, controller.state().program().ending().orElseThrow());
    assertTrue(moving());
    advance(300);
    assertFalse(controller.state().arm().moving());
    assertFalse(lines.contains("there"));
  }

  @Test
  void aPauseHoldsScriptTimeAndArmAndTheMoveStillArrives() {
    start(
        """
        def p():
         thread t():
          sleep(1)
          textmsg("slept")
         end
         h = run t()
         movej([1, -1, -1, -1, 1, 1])
         join h
        end
        """);
    advance(100);
    command(new ProgramCommand.PauseProgram());
    assertEquals(ProgramState.PAUSED, controller.state().program().state());
    advance(2000);
    assertFalse(moving());
    assertTrue(lines.isEmpty());
    command(new ProgramCommand.ResumeProgram());
    advance(390);
    assertTrue(lines.isEmpty());
    advance(20);
    assertEquals(List.of("slept"), lines);
    controller.runUntil(this::ended, LONG);
    assertEquals(new Joints(1, -1, -1, -1, 1, 1), controller.state().arm().targetPositionRad());
    assertEquals(
        0,
        controller
            .state()
            .arm()
            .actualPositionRad()
            .maxAbsDifference(new Joints(1, -1, -1, -1, 1, 1)),
        1e-4);
  }

  @Test
  void aFailingProgramStopsTheArmAndSaysWhy() {
    run(
        """
        def p():
         thread t():
          movej([1, -1, -1, -1, 1, 1])
         end
         run t()
         sleep(0.5)
         x = 1 / 0
        end
        """);
    assertTrue(failure().contains("0"), failure());
    assertEquals(7, ((Ending.Failed) controller.state().program().ending().get()).failure().line());
    assertTrue(lines.getLast().startsWith("program p stopped in line 7: "), lines.toString());
    assertFalse(controller.state().arm().moving());
  }

  @Test
  void aPathThroughASingularityStopsTheProgramAndLeavesTheArmAtRest() {
    ControllerState state =
        run(
            """
            def p():
             s = get_actual_tcp_pose()
             s[0] = -s[0]
             s[1] = -s[1]
             movel(s)
            end
            """);
    assertInstanceOf(Ending.Stopped.class, state.program().ending().orElseThrow());
    assertEquals("C154A0", state.safety().stop().orElseThrow().codeText());
    assertTrue(state.arm().fault().isPresent());
    controller.runUntil(() -> !controller.state().arm().moving(), 100);
    advance(2500);
    command(new SafetyCommand.UnlockProtectiveStop(false));
    run("textmsg(1)");
    assertTrue(controller.state().arm().fault().isEmpty());
  }

  @Test
  void argumentsAreRefusedWithValueUnitAndLimit() {
    Map<String, String> messages =
        Map.of(
            "movel(get_actual_tcp_pose(), a=-1.2)", "movel: a is -1.2 m/s\u00b2, must be above 0",
            "movej([0,0,0,0,0,0], v=0)", "movej: v is 0 rad/s, must be above 0",
            "movej([0,0,0,0,0,0], t=-1)", "movej: t is -1 s, must not be negative",
            "set_pos([0,7,0,0,0,0])",
                "set_pos: q[1] (shoulder) is 7 rad, must be -6.335545 to 6.335545 rad",
            "sleep(-1)", "sleep: t is -1 s, must not be negative",
            "stopj(0)", "stopj: a is 0 rad/s\u00b2, must be above 0",
            "set_standard_digital_out(8, True)",
                "set_standard_digital_out: n is 8, must be 0 to 7");
    messages.forEach(
        (text, message) -> {
          run(text);
          assertEquals(message, failure());
        });
  }

  @Test
  void aBlockingPopupPausesUntilItIsAnswered() {
    controller = new Controller(ControllerOptions.headless().withOperator(Operator.present()));
    start(
        """
        popup("wait", title="T", warning=True, blocking=True)
        textmsg("on")
        """);
    advance(100);
    assertEquals(ProgramState.PAUSED, controller.state().program().state());
    long number = controller.state().openPopups().getFirst().number();
    assertEquals(new Reply.Done(), command(new MessageCommand.AnswerPopup(number)));
    advance(2);
    assertEquals(List.of("on"), lines);
    assertTrue(controller.state().openPopups().isEmpty());
  }

  @Test
  void withoutAScreenABlockingPopupGoesOnByItself() {
    run(
        """
        popup("wait", blocking=True)
        textmsg("on")
        """);
    assertEquals(List.of("on"), lines);
  }

  @Test
  void inputsReachTheProgramAndFlagsOutliveIt() {
    start(
        """
        def p():
         while not get_standard_digital_in(2):
          sync()
         end
         set_flag(31, True)
         set_digital_out(9, True)
        end
        """);
    advance(50);
    assertEquals(ProgramState.RUNNING, controller.state().program().state());
    command(new IoCommand.SetInput("digital_in[2]", true));
    advance(2);
    assertEquals(ProgramState.STOPPED, controller.state().program().state());
    assertEquals(2, controller.state().io().bits(SignalBank.TOOL_OUT));
    run("textmsg(get_flag(31), get_digital_in(2))");
    assertEquals(List.of("TrueTrue"), lines);
  }

  @Test
  void inputsCanBeSetBeforehand() {
    controller =
        new Controller(ControllerOptions.headless().withInputs(Map.of("tool_in[1]", true)));
    run("textmsg(get_tool_digital_in(1), get_tool_digital_in(0))");
    assertEquals(List.of("TrueFalse"), lines);
    ControllerOptions wrong = ControllerOptions.headless().withInputs(Map.of("input", true));
    assertThrows(IllegalArgumentException.class, () -> new Controller(wrong));
  }

  @Test
  void commandsThatDoNotFitAreRefusedWithAReason() {
    Map<Command, String> reasons =
        Map.of(
            new ProgramCommand.PauseProgram(), "no program is running",
            new ProgramCommand.ResumeProgram(), "no program is paused",
            new BoxCommand.SetSpeedFraction(2), "speed fraction is 2.0, must be 0 to 1",
            new MessageCommand.AnswerPopup(5), "popup 5 is not open",
            new ProgramCommand.AbortMove(), "no move is under way");
    reasons.forEach(
        (command, reason) -> assertEquals(Optional.of(reason), command(command).complaint()));
    start(MOVE);
    Program second = program(controller, "textmsg(1)");
    assertEquals(
        new Reply.Refused(Refusal.Code.PROGRAM, "program move runs already"),
        command(new ProgramCommand.StartProgram(second)));
  }

  @Test
  void moreCommandsThanADeskHoldsAreRefusedAtOnce() {
    List<CompletableFuture<Reply>> replies = new ArrayList<>();
    for (int i = 0; i < 2000; i++) {
      replies.add(controller.submit(new IoCommand.SetInput("digital_in[0]", i % 2 == 0)));
    }
    advance();
    assertEquals(1024, replies.stream().filter(r -> r.join() instanceof Reply.Done).count());
    assertTrue(replies.stream().allMatch(CompletableFuture::isDone));
  }

  @Test
  void theSpeedSliderStretchesAMoveButNotASleep() {
    command(new BoxCommand.SetSpeedFraction(0.5));
    long before = controller.state().frame();
    run(
        "movej([0, -1.5707963267948966, -1.5707963267948966, -1.5707963267948966,"
            + " 1.5707963267948966, 1], a=2, v=1)");
    assertEquals(1500.0, (double) (controller.state().frame() - before), 2);
    before = controller.state().frame();
    run("sleep(1)");
    assertEquals(501, controller.state().frame() - before);
  }

  @Test
  void abortingAMoveLetsTheProgramGoOn() {
    start(MOVE);
    advance(100);
    command(new ProgramCommand.AbortMove());
    controller.runUntil(() -> controller.state().newestEntry() > 0, 300);
    assertEquals("there", controller.logSince(0).getFirst().text());
  }

  @Test
  void waypointIsTheGoalDuringAMoveAndTheTargetAtRest() {
    run(
        """
        def p():
         thread t():
          movej([1, -1, -1, -1, 1, 1])
         end
         h = run t()
         sleep(0.1)
         textmsg(get_target_waypoint())
         join h
         textmsg(get_target_waypoint())
         textmsg(get_forward_kin([1, -1, -1, -1, 1, 1]))
        end
        """);
    assertEquals(lines.get(0), lines.get(1));
    assertEquals(lines.get(0), lines.get(2));
  }

  @Test
  void inverseKinematicsReturnsTheJointsNearestToThoseGiven() {
    run(
        """
        def p():
         x = get_forward_kin([1, -1, -1, -1, 1, 1])
         textmsg(get_inverse_kin(x, [1.1, -1.1, -1, -1, 1, 1]))
         textmsg(get_inverse_kin_has_solution(p[2, 0, 0, 0, 0, 0]))
         t = p[0, 0, 0.1, 0, 0, 0]
         textmsg(get_inverse_kin(get_forward_kin([1, -1, -1, -1, 1, 1], t), qnear=[1, -1, -1, -1, 1, 1], tcp=t))
         get_inverse_kin(p[2, 0, 0, 0, 0, 0])
        end
        """);
    assertEquals("[1, -1, -1, -1, 1, 1]", lines.get(0));
    assertEquals("False", lines.get(1));
    assertEquals("[1, -1, -1, -1, 1, 1]", lines.get(2));
    assertTrue(failure().startsWith("get_inverse_kin: "), failure());
  }

  @Test
  void aFrameLoopDrivesTheControllerInItsOwnThread() {
    Program program = program(controller, "sleep(1)");
    try (FrameLoop loop = FrameLoop.start(controller, new VirtualClock())) {
      assertEquals(
          new Reply.Done(), controller.submit(new ProgramCommand.StartProgram(program)).join());
      assertTrue(loop.failure().isEmpty());
    }
    long frame = controller.state().frame();
    assertTrue(frame > 0);
    assertEquals(frame, controller.state().frame());
  }
}
