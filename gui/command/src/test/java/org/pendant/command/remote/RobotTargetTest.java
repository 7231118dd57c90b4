package org.pendant.command.remote;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.FrameLoop;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.WallClock;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.box.MessageCommand;
import org.pendant.controller.command.Command;
import org.pendant.controller.file.ProgramsFolder;
import org.pendant.controller.io.InputOwners;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.message.Operator;
import org.pendant.protocols.dashboard.DashboardServer;
import org.pendant.protocols.net.PeerLog;
import org.pendant.protocols.net.StateBroadcaster;
import org.pendant.protocols.primary.PrimaryServer;
import org.pendant.protocols.rtde.RtdeServer;
import org.pendant.protocols.script.ScriptHandler;
import org.pendant.protocols.server.PortNumbers;
import org.pendant.protocols.server.RemoteControl;
import org.pendant.protocols.server.Server;
import org.pendant.protocols.server.ServerContext;
import org.pendant.protocols.teachpendant.PendantSetup;
import org.pendant.protocols.teachpendant.RemotePendant;
import org.pendant.script.vm.ProgramState;
import org.pendant.testing.remote.TargetEvent;
import org.pendant.testing.remote.TargetState;
import org.pendant.testing.remote.TargetState.RunState;
import org.pendant.testing.remote.TargetTrouble;

/** A target that is a controller of Pendant's own behind its ports. */
@Tag("slow")
class RobotTargetTest {
  private static final int MOST_STATES = 5_000;

  @TempDir private Path folder;
  private final List<AutoCloseable> opened = new ArrayList<>();
  private Controller controller;
  private RobotTarget target;
  private final List<TargetEvent> events = new ArrayList<>();

  private void open(ControllerOptions options, RemoteControl remote) throws Exception {
    controller = new Controller(options.withArm(ArmChoice.IDEAL).withOperator(Operator.present()));
    FrameLoop loop = FrameLoop.start(controller, new WallClock());
    PeerLog log = new PeerLog((level, text) -> {});
    StateBroadcaster frames = new StateBroadcaster(controller.feed(), log);
    ServerContext context = new ServerContext(controller, frames, log, remote);
    PortNumbers free = PortNumbers.anyFree();
    Server rtde = RtdeServer.open(context, free);
    Server primary = PrimaryServer.open(context, free, new ScriptHandler(context));
    Server dashboard =
        DashboardServer.open(
            context,
            free,
            new RemotePendant(
                controller, new PendantSetup("ur5e", ProgramsFolder.at(folder), folder)));
    opened.addAll(List.of(loop, frames, dashboard, primary, rtde));
    target = RobotTarget.connect(address(rtde), address(primary), address(dashboard));
    opened.add(target);
    target.watch(
        Set.of(
            TargetState.TIME,
            TargetState.RUN_STATE,
            TargetState.ROBOT_MODE,
            TargetState.SAFETY_STATUS,
            TargetState.SPEED,
            TargetState.OUTPUTS,
            "input_int_register_7",
            "input_bit_registers0_to_31",
            "no_such_quantity"));
  }

  private void open() throws Exception {
    open(ControllerOptions.headless(), RemoteControl.disabled());
  }

  private static InetSocketAddress address(Server server) {
    return new InetSocketAddress(
        InetAddress.getLoopbackAddress(), server.ports().getFirst().number());
  }

  @AfterEach
  void close() throws Exception {
    for (AutoCloseable each : opened.reversed()) {
      each.close();
    }
  }

  private TargetState until(Predicate<TargetState> wanted) throws TargetTrouble {
    for (int i = 0; i < MOST_STATES; i++) {
      TargetState state = target.next();
      events.addAll(target.events());
      if (wanted.test(state)) {
        return state;
      }
    }
    throw new AssertionError("what was waited for did not come; " + events);
  }

  private void carryOut(Command command) throws TargetTrouble {
    assertEquals(Optional.empty(), target.carryOut(command));
  }

  @Test
  void aProgramRunsThereAndTellsWhatItDoes() throws Exception {
    open();
    target.begin();

    target.start("def it():\n  set_standard_digital_out(2, True)\n  textmsg(\"done\")\nend\n");
    TargetState state = until(_ -> events.contains(new TargetEvent.Ended()));

    assertEquals(
        List.of(new TargetEvent.Started(), new TargetEvent.Said("done"), new TargetEvent.Ended()),
        events);
    assertEquals(4, state.levels().standardOut());
    assertEquals(Optional.empty(), state.numbers("no_such_quantity"));
  }

  @Test
  void whatDoesNotCompileThereIsToldWithItsPlace() throws Exception {
    open();
    target.begin();

    target.start("def it():\n  pock()\nend\n");
    until(_ -> !events.isEmpty());

    TargetEvent.Failed failed = (TargetEvent.Failed) events.getFirst();
    assertEquals(2, failed.line());
  }

  @Test
  void registersAndSpeedAreWrittenAndTheSpeedPutBack() throws Exception {
    open();
    target.begin();

    carryOut(new BoxCommand.SetSpeedFraction(0.25));
    carryOut(
        new IoCommand.WriteSignals(
            InputOwners.BY_HAND,
            List.of(
                new SignalWrite.IntegerRegister(RegisterDirection.INPUT, 7, -5),
                new SignalWrite.BooleanRegister(RegisterDirection.INPUT, 3, true),
                new SignalWrite.BooleanRegister(RegisterDirection.INPUT, 4, true))));
    TargetState state =
        until(
            each ->
                each.number("input_bit_registers0_to_31", 0) == 0b11000
                    && each.number("input_int_register_7", 0) == -5);

    assertEquals(0.25, state.number(TargetState.SPEED, 0));
    target.end();
    until(each -> each.number(TargetState.SPEED, 0) == 1);
  }

  @Test
  void aProgramIsPausedContinuedAndStopped() throws Exception {
    open();
    target.begin();
    target.start("def it():\n  while True:\n    sleep(0.1)\n  end\nend\n");
    until(each -> each.runState() == RunState.PLAYING);

    carryOut(new ProgramCommand.PauseProgram());
    until(each -> each.runState() == RunState.PAUSED);
    carryOut(new ProgramCommand.ResumeProgram());
    until(each -> each.runState() == RunState.PLAYING);
    carryOut(new ProgramCommand.StopProgram());
    until(_ -> events.contains(new TargetEvent.Ended()));
  }

  @Test
  void aPopupIsToldAndClosed() throws Exception {
    open();
    target.begin();
    target.start("def it():\n  popup(\"Insert\", blocking=True)\nend\n");
    until(_ -> events.stream().anyMatch(TargetEvent.PopupOpened.class::isInstance));

    carryOut(new MessageCommand.AnswerPopup(1));

    until(_ -> events.contains(new TargetEvent.Ended()));
  }

  @Test
  void whatATestLeavesRunningIsStopped() throws Exception {
    open();
    target.begin();
    target.start("def it():\n  while True:\n    sleep(0.1)\n  end\nend\n");

    target.end();

    assertEquals(ProgramState.STOPPED, controller.state().program().state());
  }

  @Test
  void whatSomebodyElseHasLeftRunningIsStoppedBeforeATest() throws Exception {
    open();
    target.start("def it():\n  while True:\n    sleep(0.1)\n  end\nend\n");
    until(each -> each.runState() == RunState.PLAYING);

    target.begin();

    assertEquals(ProgramState.STOPPED, controller.state().program().state());
    assertEquals(List.of(), target.events());
  }

  @Test
  void anArmWithoutPowerIsNotReady() throws Exception {
    open(ControllerOptions.headless().withPower(false), RemoteControl.disabled());

    String why = assertThrows(TargetTrouble.class, target::begin).getMessage();

    assertTrue(why.contains("POWER_OFF, must be RUNNING: power it on"), why);
  }

  @Test
  void aRobotInLocalControlIsNotReady() throws Exception {
    open(ControllerOptions.headless(), new RemoteControl(true, false));

    String why = assertThrows(TargetTrouble.class, target::begin).getMessage();

    assertTrue(why.contains("local control"), why);
  }

  @Test
  void aTargetThatIsSwitchedOffIsLostAtOnce() throws Exception {
    open();
    target.begin();
    target.start("def it():\n  while True:\n    sleep(0.1)\n  end\nend\n");
    until(each -> each.runState() == RunState.PLAYING);

    ((Server) opened.get(3)).close();

    String why = assertThrows(TargetTrouble.class, () -> until(_ -> false)).getMessage();
    assertEquals("the primary port is lost: it has closed the connection", why);
  }

  @Test
  void aPortThatSpeaksSomethingElseIsNamed() throws IOException {
    try (ServerSocket other = new ServerSocket(0, 5, InetAddress.getLoopbackAddress())) {
      Thread.ofVirtual()
          .start(
              () -> {
                try (Socket socket = other.accept()) {
                  socket.getOutputStream().write(new byte[] {0, 1, 'x'});
                  var _ = socket.getInputStream().read(new byte[100]);
                } catch (IOException _) {
                  // the client has gone
                }
              });
      InetSocketAddress at = new InetSocketAddress(other.getInetAddress(), other.getLocalPort());

      String why =
          assertThrows(TargetTrouble.class, () -> RobotTarget.connect(at, at, at)).getMessage();

      assertTrue(why.startsWith("port " + at.getPort() + " (RTDE): this is no RTDE"), why);
    }
  }

  @Test
  void addressesHaveAnOffsetWhereOneIsGiven() {
    assertEquals(
        Optional.of(new TargetAddress("192.168.0.10", 0)), TargetAddress.parse("192.168.0.10"));
    assertEquals(
        Optional.of(new TargetAddress("localhost", 7000)), TargetAddress.parse("localhost:7000"));
    assertEquals(Optional.of(new TargetAddress("::1", 5)), TargetAddress.parse("[::1]:5"));
    assertEquals(Optional.empty(), TargetAddress.parse("robot:99999"));
    assertEquals(Optional.empty(), TargetAddress.parse("::1"));
    assertEquals(Optional.empty(), TargetAddress.parse(""));
  }
}
