package org.pendant.desktop.plot;

import java.util.Optional;
import java.util.stream.Stream;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.DebugCommand;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.TestController;
import org.pendant.recording.Recording;
import org.pendant.recording.RecordingRing;
import org.pendant.script.variables.VariablePath;

/** A controller whose frames are recorded. */
final class RecordedArm {
  private Controller controller = new Controller(ControllerOptions.headless());
  private RecordingRing ring = new RecordingRing(controller.state(), controller::programSource);

  void run(String program) {
    var _ =
        controller.submit(
            new ProgramCommand.StartProgram(TestController.program(controller, program)));
  }

  /** Has variables read in every frame. */
  void trace(String... paths) {
    var _ =
        controller.submit(
            new DebugCommand.TraceVariables(
                "test", Stream.of(paths).map(VariablePath::of).toList()));
  }

  void frames(int count) {
    for (int i = 0; i < count; i++) {
      controller.advance();
      ring.take(controller.state());
    }
  }

  void restart() {
    controller = new Controller(ControllerOptions.headless());
    ring = new RecordingRing(controller.state(), controller::programSource);
  }

  /** Another controller that has done the same up to a frame continues the recording. */
  void branch(int frame) {
    Recording before = recording();
    controller = new Controller(ControllerOptions.headless());
    for (int i = 0; i < frame; i++) {
      controller.advance();
    }
    ring = RecordingRing.continuing(before, controller.state(), controller::programSource);
  }

  Recording recording() {
    return ring.recording();
  }

  Controller controller() {
    return controller;
  }

  /** The quantity of this id. */
  static ChartQuantity quantity(String id) {
    Optional<ChartQuantity> found = ChartQuantities.standard().find(id);
    return found.orElseThrow();
  }
}
