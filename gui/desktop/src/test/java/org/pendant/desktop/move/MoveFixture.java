package org.pendant.desktop.move;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.Pace;
import org.pendant.controller.command.Command;
import org.pendant.kit.settings.MemorySettings;
import org.pendant.kit.settings.Settings;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;

/** The screen that moves the arm, with a controller but without a window. */
abstract class MoveFixture {
  static final int FRAMES_A_REFRESH = 17;

  final Map<String, String> remembered = new HashMap<>();
  final Settings settings = new MemorySettings(remembered);
  final List<Command> sent = new ArrayList<>();
  final List<Optional<Joints>> ghosts = new ArrayList<>();
  Controller controller = new Controller(ControllerOptions.headless());
  MovePresenter presenter = presenter();

  final MovePresenter presenter() {
    return new MovePresenter(
        command -> {
          sent.add(command);
          return controller.submit(command);
        },
        Runnable::run,
        settings,
        ArmLibrary.load("ur5e"),
        () -> controller.safety(),
        ghosts::add);
  }

  final void refresh(int times) {
    for (int i = 0; i < times; i++) {
      controller.runUntil(() -> false, FRAMES_A_REFRESH);
      presenter.take(controller.state(), Pace.REAL_TIME);
    }
  }

  final String obstacle() {
    return presenter.obstacle().map(Obstacle::text).orElse("");
  }

  final Joints position() {
    return controller.state().arm().targetPositionRad();
  }
}
