package org.pendant.protocols.primary;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ManualCommand;
import org.pendant.controller.box.ToolCentre;
import org.pendant.controller.command.Reply;
import org.pendant.controller.message.Operator;
import org.pendant.controller.safety.RobotMode;
import org.pendant.models.pose.Pose;
import org.pendant.protocols.primary.PrimaryClient.Packet;
import org.pendant.protocols.script.RunningBox;
import org.pendant.protocols.script.ScriptHandler;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.RemoteControl;

@Tag("slow")
class PrimaryServerTest {
  private static final int PRIMARY = 0;
  private static final int SECONDARY = 1;
  private static final int PRIMARY_READ_ONLY = 2;
  private static final int SECONDARY_READ_ONLY = 3;

  private final RemoteControl remote = new RemoteControl(true, true);
  private final RunningBox box =
      new RunningBox(ControllerOptions.headless().withOperator(Operator.present()), remote);
  private final PrimaryServer server =
      PrimaryServer.open(
          box.serverContext(), PortNumbers.anyFree(), new ScriptHandler(box.serverContext()));

  private PrimaryClient client(int port) throws IOException {
    return new PrimaryClient(server.ports().get(port));
  }

  @AfterEach
  void close() {
    server.close();
    box.close();
  }

  @Test
  void greetsWithVersionAndAFullState() throws Exception {
    for (int port = 0; port < 4; port++) {
      try (PrimaryClient client = client(port)) {
        Packet version = client.next();
        assertEquals(3, version.message());
        assertEquals(55, version.bytes().capacity());
        Packet second = client.next();
        assertEquals(12, second.message());
        assertEquals(24, second.bytes().capacity());
        Packet state = client.next();
        assertEquals(16, state.type());
        assertEquals(1386, state.bytes().capacity());
      }
    }
  }

  @Test
  void thenSendsThePeriodicStateWithTimesATenthOfASecondApart() throws Exception {
    try (PrimaryClient client = client(SECONDARY)) {
      client.next(each -> each.bytes().capacity() == 1386);
      Packet one = client.next();
      Packet two = client.next();
      assertEquals(716, one.bytes().capacity());
      assertEquals(716, two.bytes().capacity());
      assertEquals(100_000, two.bytes().getLong(10) - one.bytes().getLong(10));
    }
  }

  @Test
  void aCyclePrimaryClientsGetHasVariablesSignalsAndState() throws Exception {
    try (PrimaryClient client = client(PRIMARY_READ_ONLY)) {
      client.next(each -> each.type() == 16);
      assertEquals(25, client.next().type());
      assertEquals(5, client.next().type());
      assertEquals(16, client.next().type());
    }
  }

  @Test
  void aProgramStartsWritesAndStops() throws Exception {
    try (PrimaryClient client = client(PRIMARY)) {
      client.send("def hello():\n  textmsg(\"hi \", 5)\nend\n");
      client.next(each -> each.message() == 12);
      assertTrue(client.nextMessage().key("PROGRAM_XXX_STARTED", "hello"));
      Packet text = client.nextMessage();
      assertEquals(0, text.message());
      assertEquals("hi 5", text.text(15));
      assertTrue(client.nextMessage().key("PROGRAM_XXX_STOPPED", "hello"));
    }
  }

  @Test
  void aProgramReplacesTheOneThatRuns() throws Exception {
    try (PrimaryClient client = client(PRIMARY)) {
      client.send("def one():\n  while True:\n    sync()\n  end\nend\n");
      client.next(each -> each.key("PROGRAM_XXX_STARTED", "one"));
      client.send("def two():\n  sleep(0.01)\nend\n");
      assertTrue(client.nextMessage().key("PROGRAM_XXX_STOPPED", "one"));
      assertTrue(client.nextMessage().key("PROGRAM_XXX_STARTED", "two"));
      assertTrue(client.nextMessage().key("PROGRAM_XXX_STOPPED", "two"));
    }
  }

  @Test
  void stopAndTheNextProgramMayComeInOnePiece() throws Exception {
    try (PrimaryClient client = client(PRIMARY)) {
      client.send("def one():\n  while True:\n    sync()\n  end\nend\n");
      client.next(each -> each.key("PROGRAM_XXX_STARTED", "one"));
      client.send("stop program\ndef two():\n  sleep(0.01)\nend\n");
      assertTrue(client.nextMessage().key("PROGRAM_XXX_STOPPED", "one"));
      assertTrue(client.nextMessage().key("PROGRAM_XXX_STARTED", "two"));
    }
  }

  @Test
  void aBareLineIsAProgramOfItsOwn() throws Exception {
    try (PrimaryClient client = client(SECONDARY);
        PrimaryClient watcher = client(PRIMARY)) {
      watcher.next(each -> each.type() == 16);
      client.send("set_digital_out(3, True)\n");
      assertTrue(watcher.nextMessage().key("PROGRAM_XXX_STARTED", "unnamed"));
      assertTrue(watcher.nextMessage().key("PROGRAM_XXX_STOPPED", "unnamed"));
      assertEquals(8, box.controller().state().io().standardOut());
    }
  }

  @Test
  void aSecondaryProgramRunsBesideThePrimaryOne() throws Exception {
    try (PrimaryClient client = client(PRIMARY)) {
      client.send("def one():\n  while True:\n    sync()\n  end\nend\n");
      client.next(each -> each.key("PROGRAM_XXX_STARTED", "one"));
      client.send("sec s():\n  set_digital_out(1, True)\n  textmsg(\"done\")\nend\n");
      Packet text = client.nextMessage();
      assertEquals("done", text.text(15));
      assertEquals(2, box.controller().state().io().standardOut());
    }
  }

  @Test
  void aSecondaryProgramThatFailsIsReportedAndStopsNothing() throws Exception {
    try (PrimaryClient client = client(PRIMARY)) {
      client.send("def one():\n  while True:\n    sync()\n  end\nend\n");
      client.next(each -> each.key("PROGRAM_XXX_STARTED", "one"));
      client.send("sec s():\n  a = [1]\n  b = a[2]\nend\nsec t():\n  textmsg(\"on\")\nend\n");
      Packet key = client.nextMessage();
      assertEquals(7, key.message());
      assertTrue(key.text(24).startsWith("SECONDARY_PROGRAM_EXCEPTION_XXX"), key.text(24));
      assertEquals("on", client.nextMessage().text(15));
      assertEquals("one", box.controller().state().program().name());
    }
  }

  @Test
  void aProgramThatDoesNotCompileIsReportedAndTheRunningOneGoesOn() throws Exception {
    try (PrimaryClient client = client(PRIMARY)) {
      client.send("def one():\n  while True:\n    sync()\n  end\nend\n");
      client.next(each -> each.key("PROGRAM_XXX_STARTED", "one"));
      client.send("def silly()\nend\n");
      Packet exception = client.nextMessage();
      assertEquals(10, exception.message());
      assertEquals(-1, exception.bytes().getLong(5));
      assertEquals(2, exception.bytes().getInt(15));
      assertEquals(1, exception.bytes().getInt(19));
      assertEquals("syntax_error_on_line:2:end:", exception.text(23));
      client.send("def wrong():\n  nothing()\nend\nstop program\n");
      Packet unknown = client.nextMessage();
      assertEquals(2, unknown.bytes().getInt(15));
      assertEquals(3, unknown.bytes().getInt(19));
      assertEquals("compile_error_name_not_found:nothing:", unknown.text(23));
      assertTrue(client.nextMessage().key("PROGRAM_XXX_STOPPED", "one"));
    }
  }

  @Test
  void aRuntimeErrorComesBeforeTheStop() throws Exception {
    try (PrimaryClient client = client(PRIMARY)) {
      client.send("def p():\n  a = [1]\n  b = a[2]\nend\n");
      client.next(each -> each.key("PROGRAM_XXX_STARTED", "p"));
      Packet exception = client.nextMessage();
      assertEquals(10, exception.message());
      assertEquals(3, exception.bytes().getInt(15));
      assertTrue(exception.text(23).contains("index"), exception.text(23));
      assertTrue(client.nextMessage().key("PROGRAM_XXX_STOPPED", "p"));
    }
  }

  @Test
  void aProtectiveStopIsACodeAndAModeAndAProgramIsRefused() throws Exception {
    try (PrimaryClient client = client(PRIMARY)) {
      client.send("protective_stop()\n");
      Packet code = client.next(each -> each.message() == 6);
      assertEquals(209, code.bytes().getInt(15));
      assertEquals(0, code.bytes().getInt(19));
      assertEquals(2, code.bytes().getInt(23), "warning");
      Packet mode = client.nextMessage();
      assertEquals(5, mode.message());
      assertEquals(3, mode.bytes().get(23));
      Packet ended = client.nextMessage();
      assertEquals(7, ended.message());
      assertTrue(ended.text(24).startsWith("PROGRAM_XXX_STOPPED"), ended.text(24));
      client.send("def late():\n  sync()\nend\n");
      Packet refusal = client.next(each -> each.message() == 10);
      assertTrue(refusal.text(23).contains("stop"), refusal.text(23));
      client.send("sec beside():\n  set_digital_out(1, True)\nend\n");
      Packet again = client.next(each -> each.message() == 10);
      assertEquals(refusal.text(23), again.text(23));
      assertEquals(0, box.controller().state().io().standardOut());
    }
  }

  @Test
  void theStateOfAStopComesBeforeItsCodeAndTheStopCanBeUnlockedAtOnce() throws Exception {
    try (PrimaryClient client = client(PRIMARY)) {
      client.send("def p():\n  protective_stop()\n  sleep(1)\nend\n");
      boolean stopped = false;
      Packet next = client.next();
      while (next.message() != 6) {
        stopped = next.type() == 16 ? isStopped(next) : stopped;
        next = client.next();
      }
      assertTrue(stopped, "the state before the code is the one of the stop");
      client.send("set unlock protective stop\n");
      client.next(each -> each.type() == 16 && !isStopped(each));
      double unlockedS = box.controller().state().timeS();
      assertTrue(unlockedS < 4, "unlocked after " + unlockedS + " s");
      client.send("def next():\n  sync()\nend\n");
      client.next(each -> each.key("PROGRAM_XXX_STOPPED", "next"));
    }
  }

  /** The flag of the robot mode data, which come first in a state. */
  private static boolean isStopped(Packet state) {
    return state.bytes().get(22) != 0;
  }

  @Test
  void whichArmIsMeantIsOnlyNoted() throws Exception {
    try (PrimaryClient client = client(SECONDARY)) {
      client.send("set real\nset sim\n");
      assertTrue(box.nextLogged().contains("asks for the real arm"));
      assertTrue(box.nextLogged().contains("asks for the simulated arm"));
    }
  }

  @Test
  void popupsAndQuestionsAreAskedAndAnsweredByALine() throws Exception {
    try (PrimaryClient client = client(PRIMARY)) {
      client.send(
          """
          def ask():
            popup("read me")
            x = request_float_from_primary_client("Offset?")
            textmsg(x)
          end
          """);
      Packet popup = client.next(each -> each.message() == 9);
      assertEquals(8, popup.bytes().get(19));
      assertEquals("read me", popup.text(20));
      Packet question = client.next(each -> each.message() == 9);
      assertEquals(2, question.bytes().get(19));
      assertEquals("Offset?", question.text(20));
      client.send("request_value " + question.bytes().getInt(15) + " maybe\n");
      assertTrue(box.nextLogged().contains("answer is maybe, must be a number"));
      client.send("request_value " + question.bytes().getInt(15) + " 12.5\n");
      assertEquals("12.5", client.next(each -> each.message() == 0).text(15));
      client.send("request_value " + popup.bytes().getInt(15) + "\nrequest_value 99\n");
      assertTrue(box.nextLogged().endsWith("popup 99 is not open"));
      assertEquals(0, box.controller().state().openPopups().size());
    }
  }

  @Test
  void globalVariablesAreNamedAndThenUpdated() throws Exception {
    try (PrimaryClient client = client(PRIMARY)) {
      client.send(
          """
          def p():
            global count = 1
            while True:
              count = count + 1
              sync()
            end
          end
          """);
      Packet setup = client.next(each -> each.type() == 25 && each.bytes().get(13) == 0);
      assertEquals("count\n", setup.text(16));
      Packet update = client.next(each -> each.type() == 25 && each.bytes().capacity() > 16);
      assertEquals(15, update.bytes().get(16), "an int");
      int first = update.bytes().getInt(17);
      Packet later = client.next(each -> each.type() == 25 && each.bytes().capacity() > 16);
      assertTrue(later.bytes().getInt(17) > first);
      try (PrimaryClient another = client(PRIMARY)) {
        another.next(each -> each.message() == 12);
        assertEquals("count\n", another.next().text(16));
      }
    }
  }

  @Test
  void labelsThatAProgramPassesAreTold() throws Exception {
    try (PrimaryClient client = client(PRIMARY)) {
      client.send(
          """
          def job():
            $ 1 "Program"
            sleep(0.01)
            $ 2 "MoveJ"
            sleep(0.01)
            $ "no number"
            sleep(0.01)
          end
          """);
      client.next(each -> each.key("PROGRAM_XXX_STARTED", "job"));
      Packet first = client.nextMessage();
      assertEquals(14, first.message());
      assertEquals(1, first.bytes().getInt(15));
      assertEquals("Program", first.text(23).substring(0, 7));
      assertEquals(2, client.nextMessage().bytes().getInt(15));
      assertTrue(client.nextMessage().key("PROGRAM_XXX_STOPPED", "job"));
    }
  }

  @Test
  void rawCommandsReachTheBox() throws Exception {
    try (PrimaryClient client = client(SECONDARY)) {
      client.send("set speed 0.25\npower off\n");
      client.next(each -> each.type() == 16 && each.bytes().get(25) == RobotMode.POWER_OFF.code());
      assertEquals(0.25, box.controller().state().arm().speedFraction());
      client.send("set robotmode run\n");
      client.next(each -> each.type() == 16 && each.bytes().get(25) == RobotMode.RUNNING.code());
      client.send("set unlock protective stop\nset speed 7\n");
      assertTrue(box.nextLogged().startsWith("set unlock protective stop of Secondary client"));
      assertTrue(box.nextLogged().contains("speed"));
    }
  }

  @Test
  void freedriveLastsUntilRunIsWanted() throws Exception {
    try (PrimaryClient client = client(PRIMARY)) {
      client.send("set robotmode freedrive\n");
      client.next(each -> each.type() == 16 && each.bytes().get(26) == 1);
      client.send("set robotmode run\n");
      client.next(each -> each.type() == 16 && each.bytes().get(26) == 0);
    }
  }

  @Test
  void theControlModeFollowsTheProgram() throws Exception {
    try (PrimaryClient client = client(SECONDARY)) {
      client.send(
          """
          def press():
            force_mode(p[0, 0, 0, 0, 0, 0], [0, 0, 1, 0, 0, 0], [0, 0, 5, 0, 0, 0], 2, [1, 1, 1, 1, 1, 1])
            sleep(60)
          end
          """);
      client.next(each -> each.type() == 16 && each.bytes().get(26) == 2);
      client.send("stop program\n");
      client.next(each -> each.type() == 16 && each.bytes().get(26) == 0);
    }
  }

  @Test
  void anotherToolIsAnotherConfiguration() throws Exception {
    try (PrimaryClient client = client(SECONDARY)) {
      client.next(each -> each.bytes().capacity() == 1386);
      ToolCentre gripper = new ToolCentre(new Pose(0, 0, 0.1, 0, 0, 0), "gripper");
      assertEquals(
          new Reply.Done(), box.controller().submit(new ManualCommand.SetTool(gripper)).join());
      client.next(each -> each.bytes().capacity() == 1386);
      assertEquals(716, client.next().bytes().capacity());
    }
  }

  @Test
  void readOnlyPortsIgnoreWhatTheyAreSent() throws Exception {
    try (PrimaryClient client = client(SECONDARY_READ_ONLY);
        PrimaryClient watcher = client(PRIMARY)) {
      client.send("def p():\n  sync()\nend\n");
      client.next(each -> each.type() == 16);
      client.next(each -> each.type() == 16);
      watcher.send("def q():\n  sync()\nend\n");
      assertTrue(watcher.next(each -> each.message() == 7).key("PROGRAM_XXX_STARTED", "q"));
    }
  }

  @Test
  void whoConnectedInLocalControlIsToldSoAndHasToConnectAgain() throws Exception {
    remote.setRemote(false);
    try (PrimaryClient client = client(PRIMARY)) {
      client.send("def p():\n  sync()\nend\n");
      Packet code = client.next(each -> each.message() == 6);
      assertEquals(210, code.bytes().getInt(15));
      assertEquals("", box.controller().state().program().name());
      remote.setRemote(true);
      client.send("def p():\n  sync()\nend\n");
      assertEquals(210, client.next(each -> each.message() == 6).bytes().getInt(15));
      try (PrimaryClient again = client(PRIMARY)) {
        again.send("def p():\n  sync()\nend\n");
        again.next(each -> each.key("PROGRAM_XXX_STARTED", "p"));
      }
    }
  }

  @Test
  void goingLocalDisconnectsThoseWhoCouldControl() throws Exception {
    try (PrimaryClient primary = client(PRIMARY);
        PrimaryClient secondary = client(SECONDARY);
        PrimaryClient reader = client(PRIMARY_READ_ONLY)) {
      primary.next(each -> each.type() == 16);
      secondary.next(each -> each.type() == 16);
      reader.next(each -> each.type() == 16);
      remote.setRemote(false);
      primary.awaitDisconnection();
      secondary.awaitDisconnection();
      reader.next(each -> each.type() == 16);
    }
  }

  @Test
  void anUnfinishedProgramIsThrownAway() throws Exception {
    try (PrimaryClient client = client(PRIMARY)) {
      client.next(each -> each.type() == 16);
      client.send("def p():\n  sync()\nend");
      client.finish();
      client.awaitDisconnection();
    }
    String line = box.nextLogged();
    assertTrue(line.contains("unfinished script of 21 bytes"), line);
    assertEquals("", box.controller().state().program().name());
  }
}
