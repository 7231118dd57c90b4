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

  @Test
  void aRunInACellIsNotBranchedFromAndTheReasonIsTold() {
    RerunRefused refused = assertThrows(RerunRefused.class, () -> session.branch(0));
    assertTrue(
        refused.getMessage().contains("several controllers share the cell"),
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
