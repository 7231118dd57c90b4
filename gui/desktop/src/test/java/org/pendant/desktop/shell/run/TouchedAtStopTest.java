package org.pendant.desktop.shell.run;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.controller.command.Reply;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.world.Contact;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.desktop.scene.TouchedAtStop;
import org.pendant.desktop.unit.PoseForm;

final class TouchedAtStopTest {
  private static final Scene BENCH =
      new Scene(
          List.of(
              new SceneObject.Plane(
                  "bench", new Vector3(0, 0, 0.4), new Vector3(0, 0, 1), Material.DEFAULT)),
          Optional.empty(),
          List.of());

  /** The tool, which begins 0.49 m high, is driven against the bench. */
  private static ControllerState stopped() {
    Controller controller = new Controller(ControllerOptions.headless().withScene(BENCH));
    var reply =
        controller.submit(
            new ProgramCommand.StartProgram(
                TestController.program(
                    controller,
                    "movel(pose_add(get_target_tcp_pose(), p[0,0,-0.2,0,0,0]), v=0.5)\n")));
    assertTrue(controller.runUntil(() -> controller.state().safety().stop().isPresent(), 5000));
    assertEquals(new Reply.Done(), reply.join());
    return controller.state();
  }

  @Test
  void theStopCardSaysWhatTheToolRanInto() {
    ControllerState state = stopped();

    List<Contact> touched = new TouchedAtStop().of(state, BENCH);

    assertEquals(List.of("bench"), touched.stream().map(Contact::object).toList());
    StopCard card = StopCard.of(state, touched, PoseForm.STANDARD).orElseThrow();
    String fact =
        card.facts().stream()
            .filter(each -> each.name().equals("Tool touches"))
            .findFirst()
            .orElseThrow()
            .value();
    assertTrue(card.suggestion().startsWith("The tool ran into bench. "), card.suggestion());
    assertTrue(fact.matches("bench, \\d+\\.\\d\\d mm deep"), fact);
  }

  @Test
  void withoutASceneNothingIsTouched() {
    assertEquals(List.of(), new TouchedAtStop().of(stopped(), Scene.EMPTY));
  }
}
