package org.pendant.desktop.session;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.Pace;
import org.pendant.controller.TestController;
import org.pendant.controller.command.Reply;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.world.SceneObject;
import org.pendant.recording.replay.RerunRefused;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramEvent;

@Timeout(60)
final class RobotSessionCellTest {
  private RobotSession session;

  @BeforeEach
  void switchOn() throws Exception {
    session = RobotSession.start(ControllerOptions.headless());
    session.restart(SharedCell.setup());
  }

  @AfterEach
  void switchOff() {
    session.close();
  }

  private SessionMember member(String name) {
    return session.members().stream().filter(each -> each.name().equals(name)).findAny().get();
  }

  private Program program(SessionMember member, String text) {
    return TestController.program(member.robot(), text);
  }

  @Test
  void allControllersOfTheSceneAreThereAndTheFirstIsShown() {
    assertEquals(
        List.of("left", "right", "cell"),
        session.members().stream().map(SessionMember::name).toList());
    assertEquals("left", session.shown().name());
    assertEquals("ur5e", session.options().robotId());
    assertTrue(member("cell").armless());
  }

  @Test
  void whatIsAskedIsAskedOfTheControllerThatIsShown() throws Exception {
    session.show("right");
    assertEquals("ur3e", session.options().robotId());
    assertEquals(session.robot(), member("right").robot());
    SceneObject.Box table = (SceneObject.Box) session.options().scene().objects().getFirst();
    assertEquals(0.6, table.poseInBase().x(), 1e-12, "in the frame of its base");
    assertThrows(IllegalArgumentException.class, () -> session.show("middle"));
  }

  @Test
  void programsThatAreLeftBetweenTwoFramesStartInTheSameFrame() throws Exception {
    session.setPace(new Pace.Unlimited());
    Map<String, CompletableFuture<Long>> started = new ConcurrentHashMap<>();
    session.members().forEach(each -> started.put(each.name(), new CompletableFuture<>()));
    session.addCellListener(
        (member, state) -> {
          if (state.newProgramEvents().stream().anyMatch(ProgramEvent.Started.class::isInstance)) {
            started.get(member.name()).complete(state.frame());
          }
        });
    List<Program> programs =
        session.members().stream().map(each -> program(each, "sleep(1000)\n")).toList();
    List<CompletableFuture<Reply>> replies = new ArrayList<>();
    session.between(
        () -> {
          for (int i = 0; i < programs.size(); i++) {
            replies.add(session.run(session.members().get(i), programs.get(i)));
          }
        });
    for (CompletableFuture<Reply> each : replies) {
      assertInstanceOf(Reply.Done.class, each.get(30, TimeUnit.SECONDS));
    }
    long first = started.get("left").get(30, TimeUnit.SECONDS);
    assertEquals(first, started.get("right").get(30, TimeUnit.SECONDS));
    assertEquals(first, started.get("cell").get(30, TimeUnit.SECONDS));
    assertFalse(session.strangerLast());
  }

  @Test
  void aSignalGoesToTheOtherArmAlongItsWire() throws Exception {
    CompletableFuture<Boolean> arrived = new CompletableFuture<>();
    session.addCellListener(
        (member, state) -> {
          if (member.name().equals("right") && (state.io().standardIn() & 1) == 1) {
            arrived.complete(true);
          }
        });
    Program raises = program(member("left"), "set_standard_digital_out(0, True)\n");
    assertInstanceOf(
        Reply.Done.class, session.run(member("left"), raises).get(30, TimeUnit.SECONDS));
    assertTrue(arrived.get(30, TimeUnit.SECONDS));
  }

  @Test
  void listenersOfFramesSeeTheControllerThatIsShown() throws Exception {
    session.show("right");
    CompletableFuture<String> seen = new CompletableFuture<>();
    session.addFrameListener(state -> seen.complete(state.arm().description().id()));
    assertEquals("ur3e", seen.get(30, TimeUnit.SECONDS));
  }

  private static final String SWING =
      """
      while True:
        movej([0.3 * random(), -1.2, -1.8, -1.6, 1.57, 0], a=3, v=2)
        set_standard_digital_out(0, not get_standard_digital_out(0))
        movej([-0.4, -1.4, -1.6, -1.5, 1.57, 0], a=3, v=2)
      end
      """;

  /** Where each controller was in each frame, that of frame 1 first, up to {@code last}. */
  private Map<String, List<ControllerState>> seenUntil(long last) throws Exception {
    Map<String, List<ControllerState>> seen = new ConcurrentHashMap<>();
    session.members().forEach(each -> seen.put(each.name(), new ArrayList<>()));
    CompletableFuture<Boolean> there = new CompletableFuture<>();
    session.addCellListener(
        (member, state) -> {
          if (!there.isDone()) {
            seen.get(member.name()).add(state);
          }
          if (state.frame() == last && member.name().equals("cell")) {
            session.setPace(new Pace.Paused());
            there.complete(true);
          }
        });
    session.setPace(new Pace.Unlimited());
    assertTrue(there.get(30, TimeUnit.SECONDS));
    return seen;
  }

  /** The last of those that were seen in a frame. */
  private static ControllerState at(List<ControllerState> seen, long frame) {
    return seen.stream().filter(each -> each.frame() == frame).reduce((_, last) -> last).get();
  }

  private static List<Object> facts(ControllerState state) {
    return List.of(
        state.frame(),
        state.arm().targetPositionRad(),
        state.arm().actualPositionRad(),
        state.io(),
        state.program());
  }

  @Test
  void aBranchTakesAllControllersBackAndEachGoesOnAsItDid() throws Exception {
    session.run(member("left"), program(member("left"), SWING)).get(30, TimeUnit.SECONDS);
    session.run(member("right"), program(member("right"), SWING)).get(30, TimeUnit.SECONDS);
    session.show("right");
    session.setPace(new Pace.Paused());
    long last = session.state().frame() + 600;
    Map<String, List<ControllerState>> seen = seenUntil(last);
    long moment = last - 300;
    List<SessionMember> old = session.members();
    Branching branching = session.branch(session.recording().atFrame(moment));
    assertEquals(
        new Branching.Outcome.Branched(moment), branching.outcome().get(30, TimeUnit.SECONDS));
    assertEquals("right", session.shown().name());
    assertTrue(session.inCell());
    assertInstanceOf(Pace.Paused.class, session.pace());
    for (SessionMember each : session.members()) {
      assertFalse(old.contains(each));
      assertEquals(facts(at(seen.get(each.name()), moment)), facts(each.state()), each.name());
      assertEquals(moment, each.recording().lastFrame());
    }
    Map<String, List<ControllerState>> again = seenUntil(last);
    for (SessionMember each : session.members()) {
      assertEquals(
          facts(at(seen.get(each.name()), last)),
          facts(at(again.get(each.name()), last)),
          each.name());
    }
  }

  @Test
  void whatOneControllerGotFromOutsideIsToldWhereABranchIsRefused() throws Exception {
    Program asks = program(member("right"), "socket_open(\"127.0.0.1\", 9)\n");
    session.run(member("right"), asks).get(30, TimeUnit.SECONDS);
    session.setPace(new Pace.Paused());
    long last = session.state().frame() + 100;
    seenUntil(last);
    RerunRefused refused =
        assertThrows(RerunRefused.class, () -> session.branch(session.state().frame()));
    assertTrue(
        refused.getMessage().contains("then right: a program connected a socket"),
        () -> refused.getMessage());
  }

  @Test
  void oneThatIsAloneComesBackAsItWas() {
    ControllerOptions alone = session.aloneOptions();
    session.restart(alone.withRobot("ur10e"));
    assertFalse(session.inCell());
    assertEquals("", session.shown().name());
    assertEquals("ur10e", session.options().robotId());
  }

  @Test
  void theSameControllerIsShownAfterTheCellIsSwitchedOffAndOn() {
    session.show("right");
    SessionMember before = session.shown();
    session.restartWith(each -> each.withStartRamp(false));
    assertEquals("right", session.shown().name());
    assertFalse(session.options().startRamp());
    assertInstanceOf(
        Reply.Refused.class, before.submit(new IoCommand.ReleaseSignals("who")).join());
  }
}
